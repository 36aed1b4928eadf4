model Drive "What fills and empties through two drives that lag their commands"
  input Real u_in(start=0) "Command";
  input Real u_out(start=0) "Command";
  parameter Real tau(min=0.01, max=100) = 1 "Time constant of each drive";
  Real z_in(start=0, fixed=true, nominal=1) "Opening";
  Real z_out(start=0, fixed=true, nominal=1) "Opening";
  output Real y(start=0, fixed=true, nominal=1);
equation
  tau*der(z_in) = u_in - z_in;
  tau*der(z_out) = u_out - z_out;
  der(y) = z_in - z_out - y;
end Drive;

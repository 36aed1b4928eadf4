within WindTunnel.Interfaces;
partial model Tachometer "Reading of both speeds; left open: the equations of y_in and y_out"
  input Real w_in(unit="rad/s") "Speed of the intake fan";
  input Real w_out(unit="rad/s") "Speed of the exhaust fan";
  Real y_in(unit="rad/s") "Reading of the intake fan";
  Real y_out(unit="rad/s") "Reading of the exhaust fan";
end Tachometer;

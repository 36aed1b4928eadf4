within WindTunnel.Interfaces;
partial model Drive "From the commanded loads to those that the motors get; left open: the equations of L_in and L_out"
  input Real u_in(unit="1") "Commanded load of the intake fan";
  input Real u_out(unit="1") "Commanded load of the exhaust fan";
  Real L_in(unit="1") "Load of the intake fan";
  Real L_out(unit="1") "Load of the exhaust fan";
end Drive;

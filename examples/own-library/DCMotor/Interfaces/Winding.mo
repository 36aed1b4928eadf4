within DCMotor.Interfaces;
partial model Winding "Resistance of a winding; left open: the equation of R"
  input Real i(unit="A") "Current";
  parameter Real R_cold(unit="Ohm", min=0) "Resistance of the cold winding";
  Real R(unit="Ohm") "Resistance";
end Winding;

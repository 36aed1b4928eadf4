within DCMotor.Interfaces;
connector Flange "A shaft"
  Real phi(unit="rad") "Angle";
  flow Real tau(unit="N.m") "Torque into the part";
end Flange;

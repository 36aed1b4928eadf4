within WindTunnel.Interfaces;
connector Shaft "A shaft"
  Real w(unit="rad/s") "Speed";
  flow Real tau(unit="N.m") "Torque into the part";
end Shaft;

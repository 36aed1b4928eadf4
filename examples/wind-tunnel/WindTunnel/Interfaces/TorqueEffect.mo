within WindTunnel.Interfaces;
partial model TorqueEffect "An effect that adds a torque to each fan; left open: the equations of tau_in and tau_out"
  extends FanTerminals;
  extends Effect(final balance="torque");
  outer Components.Air air "Hatch";
  Real w_in(unit="rad/s") "Speed of the intake fan";
  Real w_out(unit="rad/s") "Speed of the exhaust fan";
  Real tau_in(unit="N.m") "Torque against the rotation of the intake fan";
  Real tau_out(unit="N.m") "Torque against the rotation of the exhaust fan";
equation
  w_in = intake.w;
  w_out = exhaust.w;
  intake.tau = tau_in;
  exhaust.tau = tau_out;
end TorqueEffect;

within DCMotor.Interfaces;
partial model TorqueEffect "An effect that adds a torque in parallel to the motor; left open: the equation of tau"
  extends MotorTerminals;
  extends Effect(final balance="torque");
  Real tau(unit="N.m") "Torque against rotation";
  Real w(unit="rad/s") "Speed";
  Real i(unit="A") "Current";
equation
  w = der(shaft.phi);
  i = mesh.i;
  shaft.tau = tau;
  mesh.v = 0;
end TorqueEffect;

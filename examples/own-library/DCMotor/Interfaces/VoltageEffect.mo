within DCMotor.Interfaces;
partial model VoltageEffect "An effect that adds a voltage in the circuit of the motor; left open: the equation of v"
  extends MotorTerminals;
  extends Effect(final balance="voltage");
  Real v(unit="V") "Voltage against the current";
  Real w(unit="rad/s") "Speed";
  Real i(unit="A") "Current";
equation
  w = der(shaft.phi);
  i = mesh.i;
  mesh.v = v;
  shaft.tau = 0;
end VoltageEffect;

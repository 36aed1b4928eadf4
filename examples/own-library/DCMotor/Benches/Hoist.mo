within DCMotor.Benches;
model Hoist "A motor that lifts a weight with a rope on a drum"
  input Real u(unit="V", start=12) "Voltage";
  output Real i(unit="A") "Current";
  output Real w(unit="rad/s") "Speed";
  Components.VoltageSource source(u=u) "Supply";
  Components.Motor motor "Motor";
  Components.Flywheel flywheel "Rotor";
  Components.Drum drum "Drum with rope and weight";
equation
  connect(source.mesh, motor.mesh);
  connect(motor.shaft, flywheel.shaft);
  connect(motor.shaft, drum.shaft);
  i = motor.mesh.i;
  w = flywheel.w;
  annotation (experiment(StopTime=4, Interval=0.005));
end Hoist;

within DCMotor.Benches;
model FreeRun "A motor that turns a flywheel"
  input Real u(unit="V", start=12) "Voltage";
  output Real i(unit="A") "Current";
  output Real w(unit="rad/s") "Speed";
  Components.VoltageSource source(u=u) "Supply";
  Components.Motor motor "Motor";
  Components.Flywheel flywheel "Flywheel";
equation
  connect(source.mesh, motor.mesh);
  connect(motor.shaft, flywheel.shaft);
  i = motor.mesh.i;
  w = flywheel.w;
  annotation (experiment(StopTime=4, Interval=0.005));
end FreeRun;

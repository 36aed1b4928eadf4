within DCMotor.Benches;
model LockedRotor "A motor whose shaft is held"
  input Real u(unit="V", start=2) "Voltage";
  output Real i(unit="A") "Current";
  Components.VoltageSource source(u=u) "Supply";
  Components.Motor motor "Motor";
  Components.Clamp clamp "Holds the shaft";
equation
  connect(source.mesh, motor.mesh);
  connect(motor.shaft, clamp.shaft);
  i = motor.mesh.i;
  annotation (experiment(StopTime=1, Interval=0.001));
end LockedRotor;

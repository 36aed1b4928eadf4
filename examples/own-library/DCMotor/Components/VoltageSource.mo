within DCMotor.Components;
model VoltageSource "An ideal voltage"
  Interfaces.Mesh mesh "Circuit";
  input Real u(unit="V") "Voltage";
equation
  mesh.v = -u;
end VoltageSource;

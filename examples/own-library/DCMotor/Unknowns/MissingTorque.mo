within DCMotor.Unknowns;
model MissingTorque "A torque that no law explains"
  extends TorqueTerm(final family="unknown", final absent="tau_missing=0");
  parameter Real tau_missing(unit="N.m", min=-100, max=100) = 0 "Missing torque, positive against rotation";
equation
  missing = tau_missing;
end MissingTorque;

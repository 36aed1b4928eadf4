within WindTunnel.Unknowns;
model MissingIntakeTorque "A torque on the intake fan that no law explains"
  extends IntakeTorqueTerm(final family="unknown", final absent="tau_missing=0");
  parameter Real tau_missing(unit="N.m", min=-1, max=1) = 0 "Missing torque, positive against rotation";
equation
  missing = tau_missing;
end MissingIntakeTorque;

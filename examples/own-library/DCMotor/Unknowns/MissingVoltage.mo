within DCMotor.Unknowns;
model MissingVoltage "A voltage that no law explains"
  extends VoltageTerm(final family="unknown", final absent="v_missing=0");
  parameter Real v_missing(unit="V", min=-1e4, max=1e4) = 0 "Missing voltage, positive against the current";
equation
  missing = v_missing;
end MissingVoltage;

within DCMotor.Unknowns;
partial model VoltageTerm "A further voltage in the circuit; left open: the equation of missing"
  extends Interfaces.VoltageEffect;
  Real missing(unit="V") "Voltage, positive against the current";
equation
  v = missing;
end VoltageTerm;

within DCMotor.Unknowns;
partial model TorqueTerm "A further torque on the shaft; left open: the equation of missing"
  extends Interfaces.TorqueEffect;
  Real missing(unit="N.m") "Torque, positive against rotation";
equation
  tau = missing;
end TorqueTerm;

within WindTunnel.Unknowns;
partial model IntakeTorqueTerm "A further torque on the intake fan; left open: the equation of missing"
  extends Interfaces.TorqueEffect;
  Real missing(unit="N.m") "Torque, positive against rotation";
equation
  tau_in = missing;
  tau_out = 0;
end IntakeTorqueTerm;

within PneumaticMuscle.Unknowns;
model MissingHeatOfBalancedGas "A heat flow that no law explains into a gas that keeps books of mass and energy"
  extends BalancedGasTerm;
  extends Interfaces.Effect(final family="unknown", final balance="energy");
  parameter Types.Power Q_flow_missing(min=-1e6, max=1e6) = 0 "Missing heat flow, positive into the gas"
    annotation (Dialog(group="Missing term"));
equation
  missing = Q_flow_missing;
  annotation (Documentation(info="<html>
<p>missing = Q_flow_missing, which an estimator moves over time.</p>
</html>"));
end MissingHeatOfBalancedGas;

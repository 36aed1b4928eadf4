within PneumaticMuscle.Unknowns;
model MissingHeat "A heat flow into the gas that no law explains"
  extends HeatTerm(final family="unknown", final absent="Q_flow_missing=0");
  parameter Types.Power Q_flow_missing(min=-1e6, max=1e6) = 0 "Missing heat flow, positive into the gas"
    annotation (Dialog(group="Missing term"));
equation
  missing = Q_flow_missing;
  annotation (Documentation(info="<html>
<p>missing = Q_flow_missing, which an estimator moves over time.</p>
</html>"));
end MissingHeat;

within PneumaticMuscle.Unknowns;
model MissingMassFlow "A mass flow into the gas that no law explains"
  extends MassFlowTerm(final family="unknown", final absent="m_flow_missing=0");
  parameter Types.MassFlowRate m_flow_missing(min=-1, max=1) = 0 "Missing mass flow, positive into the gas"
    annotation (Dialog(group="Missing term"));
equation
  missing = m_flow_missing;
  annotation (Documentation(info="<html>
<p>missing = m_flow_missing, which an estimator moves over time.</p>
</html>"));
end MissingMassFlow;

within PneumaticMuscle.Unknowns;
model MissingForce "A force between the ends of the muscle that no law explains"
  extends ForceTerm(final family="unknown", final absent="f_missing=0");
  parameter Types.Force f_missing(min=-1e5, max=1e5) = 0 "Missing force, positive against contraction"
    annotation (Dialog(group="Missing term"));
equation
  missing = f_missing;
  annotation (Documentation(info="<html>
<p>missing = f_missing, which an estimator moves over time.</p>
</html>"));
end MissingForce;

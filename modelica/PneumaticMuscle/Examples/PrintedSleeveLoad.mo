within PneumaticMuscle.Examples;
model PrintedSleeveLoad "The vertical load with the stretched sleeve as printed, DY (12)"
  extends Benches.VerticalLoad(muscle(redeclare model Elasticity = Laws.Elasticities.PrintedSleeve));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>With L_o = L the sleeve is a spring that begins at eps = 0; see
<a href=\"modelica://PneumaticMuscle.Laws.Elasticities.PrintedSleeve\">Laws.Elasticities.PrintedSleeve</a> for another
<code>muscle.elasticity.L_o</code>.</p>
</html>"));
end PrintedSleeveLoad;

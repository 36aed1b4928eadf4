within PneumaticMuscle.Examples;
model MooneyRivlinMuscle "A bladder of Mooney-Rivlin rubber"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord,
    redeclare model Bladder = Effects.Elasticity.MooneyRivlinBladder));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Wang's bladder, discussed after <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12).</p>
</html>"));
end MooneyRivlinMuscle;

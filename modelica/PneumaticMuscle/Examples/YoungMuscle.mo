within PneumaticMuscle.Examples;
model YoungMuscle "A bladder of Hooke's rubber"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord,
    redeclare model Bladder = Effects.Elasticity.YoungBladder));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Ferraresi's bladder, discussed after <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12).</p>
</html>"));
end YoungMuscle;

within PneumaticMuscle.Examples;
model TonduMuscle "Tondu's factor on the strain, DY (1)-(2)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Tondu));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Contracts by 1/k of what <a href=\"modelica://PneumaticMuscle.Examples.GaylordMuscle\">GaylordMuscle</a> does.</p>
</html>"));
end TonduMuscle;

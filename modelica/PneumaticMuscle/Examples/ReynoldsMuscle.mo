within PneumaticMuscle.Examples;
model ReynoldsMuscle "Three elements in parallel, DP (6)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Reynolds));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Coefficients of the size of the latex muscle.</p>
</html>"));
end ReynoldsMuscle;

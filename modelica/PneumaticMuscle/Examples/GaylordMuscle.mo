within PneumaticMuscle.Examples;
model GaylordMuscle "Gaylord's force, DP (1)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The law of the base model. Nothing damps the hanging mass here but the flow through the valve: it rings.</p>
</html>"));
end GaylordMuscle;

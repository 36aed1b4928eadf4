within PneumaticMuscle.Examples;
model BarrelMuscle "The advanced geometry of Tothova and Pitel, DP (9), with Bernoulli's flow, DP (10)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.TothovaPitel),
    valve(redeclare model Flow = Laws.Flows.Bernoulli));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Geometry and flow of one author.</p>
</html>"));
end BarrelMuscle;

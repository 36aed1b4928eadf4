within PneumaticMuscle.Examples;
model KerscherMuscle "Kerscher's factors on strain and force, DY (5)-(7)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Kerscher));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>With mu chosen for illustration.</p>
</html>"));
end KerscherMuscle;

within PneumaticMuscle.Examples;
model CaoPiecewiseMuscle "Two linear models that meet at 200 kPa, after DP (7)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.CaoPiecewise), p_supply(start=300e3));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The slope of the force by pressure halves at 200 kPa; the supply is above it.</p>
</html>"));
end CaoPiecewiseMuscle;

within PneumaticMuscle.Examples;
model CaoQuadraticMuscle "Polynomial in contraction and speed, DP (7)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.CaoQuadratic));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Coefficients of the size of the latex muscle.</p>
</html>"));
end CaoQuadraticMuscle;

within PneumaticMuscle.Examples;
model KangMuscle "Kang's factor by pressure, and his friction, DP (4)-(5)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Kang,
    redeclare model Friction = Laws.Frictions.CoulombViscous));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Force and friction of one author.</p>
</html>"));
end KangMuscle;

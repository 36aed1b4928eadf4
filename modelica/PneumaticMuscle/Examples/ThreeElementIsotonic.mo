within PneumaticMuscle.Examples;
model ThreeElementIsotonic "The isotonic bench with the shape of two frustums and a cylinder, DP (13)"
  extends Benches.Isotonic(muscle(redeclare model Braid = Laws.Forces.ThreeElementShape), load(m=12),
    p_supply(start=110e3));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>A larger mass and a lower supply than <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>'s, so that
the muscle stays within the range of the shape: <code>muscle.braid.margin</code> must not become negative.</p>
</html>"));
end ThreeElementIsotonic;

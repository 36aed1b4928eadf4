within PneumaticMuscle.Examples;
model ConstantFrictionLoad
  "The vertical load with Coulomb and viscous friction of constant coefficients, DY (8)-(9), Fig. 6a"
  extends Benches.VerticalLoad(muscle(redeclare model Friction = Laws.Frictions.CoulombViscous));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a>'s existing model, which cannot follow loops at
several loads and frequencies at once.
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.LoadFrequencyFriction\">LoadFrequencyFriction</a>
makes it theirs, Fig. 6b; <code>docs/stories.md</code> finds it from data.</p>
</html>"));
end ConstantFrictionLoad;

within PneumaticMuscle.Interfaces;
partial model ForceEffect "An effect that adds a force in parallel with the muscle"
  extends ForceElement;
  extends Effect(final balance="force");
  extends Icons.ForceEffect;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of f, its family and its parameters.</p>
</html>"));
end ForceEffect;

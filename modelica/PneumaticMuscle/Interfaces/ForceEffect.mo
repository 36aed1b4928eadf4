within PneumaticMuscle.Interfaces;
partial model ForceEffect "An effect that adds a force in parallel with the muscle"
  extends ForceElement;
  extends Effect(final balance="force");
end ForceEffect;

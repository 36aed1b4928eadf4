within PneumaticMuscle.Interfaces;
partial model GasPortEffect "An effect that takes gas from a vessel or a muscle"
  extends VesselTerminals;
  extends Effect(final balance="mass");
  outer Components.Ambient ambient "Surroundings";
end GasPortEffect;

within PneumaticMuscle.Interfaces;
partial model Surroundings "What a wall gives its heat to"
  HeatPort heatPort "Outer side of the wall";
  outer Components.Ambient ambient "Surroundings of the bench";
end Surroundings;

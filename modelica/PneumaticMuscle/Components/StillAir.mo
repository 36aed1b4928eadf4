within PneumaticMuscle.Components;
model StillAir "Surroundings that take any heat without getting warmer"
  extends Interfaces.Surroundings;
equation
  heatPort.T = ambient.T;
end StillAir;

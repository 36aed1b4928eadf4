within PneumaticMuscle.Components;
model MetalWall "A thick wall that stays at ambient temperature: only the film on the gas side resists"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow = h_film*A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
end MetalWall;

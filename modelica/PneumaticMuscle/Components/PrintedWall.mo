within PneumaticMuscle.Components;
model PrintedWall "A bladder without films of air, DP (45) as printed"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow = k/t*A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
end PrintedWall;

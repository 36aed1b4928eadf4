within PneumaticMuscle.Components;
model PrintedWall "A bladder without films of air, DP (45) as printed"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow = k/t*A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
  annotation (Documentation(info="<html>
<p>Q_flow = k/t A (T - T_outside), DP (44)-(45) as printed. With it a muscle on 207 kPa stalls at 50 kPa, see
<code>FilmWall</code>; kept to show that.</p>
</html>"));
end PrintedWall;

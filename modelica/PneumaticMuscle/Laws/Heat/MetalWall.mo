within PneumaticMuscle.Laws.Heat;
model MetalWall "A thick wall that stays at ambient temperature: only the film on the gas side resists"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow = h_film*A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
  annotation (Documentation(info="<html>
<p>Q_flow = h A (T - T_outside), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (44) with the film
inside alone.</p>
</html>"));
end MetalWall;

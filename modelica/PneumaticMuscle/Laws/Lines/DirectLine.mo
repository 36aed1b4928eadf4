within PneumaticMuscle.Laws.Lines;
model DirectLine "No line: the valves sit on the muscle or vessel"
  extends Interfaces.Line;
equation
  connect(port_a, port_b)
    annotation (Line(points={{-100,0}, {100,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>The two ends are one place: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> know of no losses
between valve and muscle.</p>
</html>"));
end DirectLine;

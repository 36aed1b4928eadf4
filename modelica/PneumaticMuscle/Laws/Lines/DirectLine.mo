within PneumaticMuscle.Laws.Lines;
model DirectLine "No line: the valves sit on the muscle or vessel"
  extends Interfaces.Line;
equation
  connect(port_a, port_b);
  annotation (Documentation(info="<html>
<p>The two ends are one place: DP know of no losses between valve and muscle.</p>
</html>"));
end DirectLine;

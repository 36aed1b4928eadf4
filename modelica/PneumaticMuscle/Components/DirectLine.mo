within PneumaticMuscle.Components;
model DirectLine "No line: the valves sit on the muscle or vessel"
  extends Interfaces.Line;
equation
  connect(port_a, port_b);
end DirectLine;

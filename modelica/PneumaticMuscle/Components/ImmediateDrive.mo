within PneumaticMuscle.Components;
model ImmediateDrive "The valves follow their currents at once, as DP assume"
  extends Interfaces.ValveDrive;
equation
  y = u;
end ImmediateDrive;

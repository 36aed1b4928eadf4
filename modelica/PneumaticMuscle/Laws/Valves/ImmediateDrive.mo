within PneumaticMuscle.Laws.Valves;
model ImmediateDrive "The valves follow their currents at once, as DP assume"
  extends Interfaces.ValveDrive;
equation
  y = u;
  annotation (Documentation(info="<html>
<p>y = u: DP leave out the dynamics of the valves.</p>
</html>"));
end ImmediateDrive;

within PneumaticMuscle.Laws.Valves;
model ImmediateDrive "The valves follow their currents at once, as DP assume"
  extends Interfaces.ValveDrive;
equation
  y = u;
  annotation (Documentation(info="<html>
<p>y = u: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> leave out the dynamics of the valves.</p>
</html>"));
end ImmediateDrive;

within PneumaticMuscle.Laws.Valves;
model ImmediateOpening "The valves open with their currents without delay, as DP assume"
  extends Interfaces.ValveOpening;
equation
  A = A_set;
  annotation (Documentation(info="<html>
<p>A = A_set: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> leave out the dynamics of the
valves.</p>
</html>"));
end ImmediateOpening;

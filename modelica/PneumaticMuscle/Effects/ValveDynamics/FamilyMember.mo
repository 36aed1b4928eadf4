within PneumaticMuscle.Effects.ValveDynamics;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="valve_dynamics", final balance="mass");
  extends Icons.ValveDynamics;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.ValveDrive\">Interfaces.ValveDrive</a>, before
the law of the area, or <a href=\"modelica://PneumaticMuscle.Interfaces.ValveOpening\">Interfaces.ValveOpening</a>,
behind it, whose place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

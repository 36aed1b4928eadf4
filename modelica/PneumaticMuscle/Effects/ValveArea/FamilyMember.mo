within PneumaticMuscle.Effects.ValveArea;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="valve_area", final balance="mass");
  extends Icons.ValveArea;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.ValveArea\">Interfaces.ValveArea</a>, whose
place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

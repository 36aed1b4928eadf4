within PneumaticMuscle.Effects.ValveArea;
partial model FamilyMember "What every member of the family says of itself"
  extends Interfaces.Effect(final family="valve_area", final balance="mass");
  extends Icons.ValveArea;
  annotation (Documentation(info="<html>
<p>A member also extends <code>Interfaces.ValveArea</code>, whose place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

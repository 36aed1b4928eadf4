within PneumaticMuscle.Effects.PressureOffset;
partial model FamilyMember "What every member of the family says of itself"
  extends Interfaces.Effect(final family="pressure_offset", final balance="sensor");
  extends Icons.PressureOffset;
  annotation (Documentation(info="<html>
<p>A member also extends <code>Interfaces.Manometer</code>, whose place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

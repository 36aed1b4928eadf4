within PneumaticMuscle.Effects.PressureOffset;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="pressure_offset", final balance="sensor");
  extends Icons.PressureOffset;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Manometer\">Interfaces.Manometer</a>, whose
place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

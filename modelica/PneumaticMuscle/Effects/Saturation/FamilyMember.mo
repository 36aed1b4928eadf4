within PneumaticMuscle.Effects.Saturation;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="saturation", final balance="sensor");
  extends Icons.Saturation;
  annotation (Documentation(info="<html>
<p>A member also extends the interface of its channel, such as
<a href=\"modelica://PneumaticMuscle.Interfaces.PressureChannel\">Interfaces.PressureChannel</a>, whose place it takes,
and gives its equations.</p>
</html>"));
end FamilyMember;

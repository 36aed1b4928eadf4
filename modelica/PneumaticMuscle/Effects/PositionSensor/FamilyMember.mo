within PneumaticMuscle.Effects.PositionSensor;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="position_sensor", final balance="sensor");
  extends Icons.PositionSensor;
  annotation (Documentation(info="<html>
<p>A member also extends
<a href=\"modelica://PneumaticMuscle.Interfaces.PositionChannel\">Interfaces.PositionChannel</a>, whose place it takes,
and gives its equations.</p>
</html>"));
end FamilyMember;

within PneumaticMuscle.Effects.PositionSensor;
partial model FamilyMember "What every member of the family says of itself"
  extends Interfaces.Effect(final family="position_sensor", final balance="sensor");
  extends Icons.PositionSensor;
  annotation (Documentation(info="<html>
<p>A member also extends
<a href=\"modelica://PneumaticMuscle.Interfaces.PositionChannel\">Interfaces.PositionChannel</a>, whose place it takes,
and gives its equations.</p>
</html>"));
end FamilyMember;

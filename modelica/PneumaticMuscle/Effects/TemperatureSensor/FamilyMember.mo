within PneumaticMuscle.Effects.TemperatureSensor;
partial model FamilyMember "What every member of the family says of itself"
  extends Interfaces.Effect(final family="temperature_sensor", final balance="sensor");
  extends Icons.TemperatureSensor;
  annotation (Documentation(info="<html>
<p>A member also extends
<a href=\"modelica://PneumaticMuscle.Interfaces.TemperatureChannel\">Interfaces.TemperatureChannel</a>, whose place it
takes, and gives its equations.</p>
</html>"));
end FamilyMember;

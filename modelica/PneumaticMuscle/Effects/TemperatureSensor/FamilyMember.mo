within PneumaticMuscle.Effects.TemperatureSensor;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="temperature_sensor", final balance="sensor");
  extends Icons.TemperatureSensor;
  annotation (Documentation(info="<html>
<p>A member also extends
<a href=\"modelica://PneumaticMuscle.Interfaces.TemperatureChannel\">Interfaces.TemperatureChannel</a>, whose place it
takes, and gives its equations.</p>
</html>"));
end FamilyMember;

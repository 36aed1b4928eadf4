within PneumaticMuscle.Effects.PressureSensorLag;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="pressure_sensor_lag", final balance="sensor");
  extends Icons.PressureSensorLag;
  annotation (Documentation(info="<html>
<p>A member also extends
<a href=\"modelica://PneumaticMuscle.Interfaces.PressureChannel\">Interfaces.PressureChannel</a>, whose place it takes,
and gives its equations.</p>
</html>"));
end FamilyMember;

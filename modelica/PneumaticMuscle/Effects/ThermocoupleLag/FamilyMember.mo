within PneumaticMuscle.Effects.ThermocoupleLag;
partial model FamilyMember "What every member of the family says of itself"
  extends Interfaces.Effect(final family="thermocouple_lag", final balance="sensor");
  extends Icons.ThermocoupleLag;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Thermometer\">Interfaces.Thermometer</a>, whose
place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

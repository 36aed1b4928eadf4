within PneumaticMuscle.Effects.ThermocoupleLag;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="thermocouple_lag", final balance="sensor");
  extends Icons.ThermocoupleLag;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Thermometer\">Interfaces.Thermometer</a>, whose
place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

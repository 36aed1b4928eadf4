within PneumaticMuscle.Effects.ForceSensor;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="force_sensor", final balance="sensor");
  extends Icons.ForceSensor;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.ForceChannel\">Interfaces.ForceChannel</a>,
whose place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

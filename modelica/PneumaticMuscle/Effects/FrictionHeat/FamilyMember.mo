within PneumaticMuscle.Effects.FrictionHeat;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="friction_heat", final balance="energy");
  extends Icons.FrictionHeat;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.FrictionHeat\">Interfaces.FrictionHeat</a>,
whose place it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

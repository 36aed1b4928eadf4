within PneumaticMuscle.Effects.Elasticity;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.ForceEffect(final family="elasticity");
  extends Icons.Elasticity;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of f, and its parameters.</p>
</html>"));
end FamilyMember;

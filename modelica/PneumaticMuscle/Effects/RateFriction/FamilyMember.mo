within PneumaticMuscle.Effects.RateFriction;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.ForceEffect(final family="rate_friction");
  extends Icons.RateFriction;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of f, and its parameters.</p>
</html>"));
end FamilyMember;

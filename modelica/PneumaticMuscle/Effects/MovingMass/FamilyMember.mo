within PneumaticMuscle.Effects.MovingMass;
partial model FamilyMember "What every member of the family says of itself"
  extends Interfaces.ForceEffect(final family="moving_mass");
  extends Icons.MovingMass;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of f, and its parameters.</p>
</html>"));
end FamilyMember;

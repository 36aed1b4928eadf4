within PneumaticMuscle.Effects.MovingMass;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.ForceEffect(final family="moving_mass");
  extends Icons.MovingMass;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of f, and its parameters.</p>
</html>"));
end FamilyMember;

within PneumaticMuscle.Effects.Creep;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.ForceEffect(final family="creep");
  extends Icons.Creep;
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of f, and its parameters.</p>
</html>"));
end FamilyMember;

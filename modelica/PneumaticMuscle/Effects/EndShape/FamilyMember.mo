within PneumaticMuscle.Effects.EndShape;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="end_shape", final balance="force");
  extends Icons.EndShape;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Cylinder\">Interfaces.Cylinder</a>, whose place
it takes, and gives its equations.</p>
</html>"));
end FamilyMember;

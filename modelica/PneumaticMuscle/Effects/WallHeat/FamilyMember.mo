within PneumaticMuscle.Effects.WallHeat;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="wall_heat", final balance="energy");
  extends Icons.WallHeat;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Surroundings\">Interfaces.Surroundings</a> or
<a href=\"modelica://PneumaticMuscle.Interfaces.Wall\">Interfaces.Wall</a>, whose place it takes, and gives its
equations.</p>
</html>"));
end FamilyMember;

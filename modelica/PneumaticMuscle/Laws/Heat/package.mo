within PneumaticMuscle.Laws;
package Heat "Where the heat of the gas and of friction goes"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>A wall extends <a href=\"modelica://PneumaticMuscle.Interfaces.Wall\">Interfaces.Wall</a>, what it gives its heat to
<a href=\"modelica://PneumaticMuscle.Interfaces.Surroundings\">Interfaces.Surroundings</a>, and what becomes of the heat
of friction <a href=\"modelica://PneumaticMuscle.Interfaces.FrictionHeat\">Interfaces.FrictionHeat</a>; each is
redeclared in a muscle or a vessel.</p>
</html>"));
end Heat;

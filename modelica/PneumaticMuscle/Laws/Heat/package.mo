within PneumaticMuscle.Laws;
package Heat "Where the heat of the gas and of friction goes"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>A wall extends <code>Interfaces.Wall</code>, what it gives its heat to <code>Interfaces.Surroundings</code>, and what becomes
of the heat of friction <code>Interfaces.FrictionHeat</code>; each is redeclared in a muscle or a vessel.</p>
</html>"));
end Heat;

within PneumaticMuscle.Laws;
package Elasticities "Force of the stretched sleeve without pressure"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.SleeveElasticity\">Interfaces.SleeveElasticity</a> and
is redeclared as the <code>Elasticity</code> of an empirical muscle.</p>
</html>"));
end Elasticities;

within PneumaticMuscle.Laws;
package Lines "Between the valves and the muscle or vessel, and what such lines are made of"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Laws.Lines.DirectLine\">DirectLine</a> extends
<a href=\"modelica://PneumaticMuscle.Interfaces.Line\">Interfaces.Line</a>, as do the members of
<a href=\"modelica://PneumaticMuscle.Effects.SupplyLine\">Effects.SupplyLine</a>, and is redeclared as the
<code>Line</code> of a bench. The tubes extend
<a href=\"modelica://PneumaticMuscle.Interfaces.TwoGasPorts\">Interfaces.TwoGasPorts</a>: laws of flow by length and
diameter, or fitted ones. The volumes of gas stand between them.</p>
</html>"));
end Lines;

within PneumaticMuscle.Laws;
package Lines "Between the valves and the muscle or vessel, and what such lines are made of"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p><code>DirectLine</code> extends <code>Interfaces.Line</code>, as do the members of <code>Effects.SupplyLine</code>, and is
redeclared as the <code>Line</code> of a bench. The tubes extend <code>Interfaces.TwoGasPorts</code>: laws of flow by length and
diameter, or fitted ones. The volumes of gas stand between them.</p>
</html>"));
end Lines;

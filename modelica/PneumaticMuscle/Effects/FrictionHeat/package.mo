within PneumaticMuscle.Effects;
package FrictionHeat "Heat of friction that reaches the gas"
  extends Icons.FrictionHeat;
  annotation (Documentation(info="<html>
<p>The family <code>friction_heat</code>: a part of the work of friction, as heat into the gas.</p>
<p>Fingerprint: pressure and temperature are a little higher while the muscle moves, and nothing happens in holds.
Members differ in the weight of contraction against extension and of slow against fast.</p>
</html>"));
end FrictionHeat;

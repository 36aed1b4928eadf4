within PneumaticMuscle.UsersGuide;
class HowToAddAnEffect "One file, one physical effect"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<ol>
<li>Choose the interface by what the effect does: a force in parallel with the muscle extends
<code>Interfaces.ForceEffect</code> and gives the equation of <code>f</code>; gas that leaves extends
<code>Interfaces.GasPortEffect</code>; a law that takes the place of another extends the constraining class of that place
(<code>Interfaces.Gas</code>, <code>ValveDrive</code>, <code>ValveArea</code>, <code>Line</code>, <code>Braid</code>,
<code>Thermometer</code>, <code>Manometer</code>, a measuring channel such as <code>PositionChannel</code>, ...) and <code>Interfaces.Effect</code>.</li>
<li>Put it into the package of its family: <code>extends FamilyMember(final absent=...)</code> says family and balance, and
for a force or a leak the interface too; <code>absent</code> lists the parameter values at which it vanishes. Outside the
library it extends <code>PneumaticMuscle.Effects.Elasticity.FamilyMember</code>, or says a <code>family</code> of its own.</li>
<li>Give every parameter that a measurement is to tell a unit, a minimum, a maximum and a typical value.</li>
<li>Use expressions with finite derivatives: <code>tanh</code> for a sign, <code>Functions.smoothMax</code> for a corner.</li>
<li>Write equation, source, typical values and fingerprint (what a measurement shows) into the documentation.</li>
</ol>
<p><code>Examples.ElasticButyl</code> shows an effect connected by hand.</p>
</html>"));
end HowToAddAnEffect;

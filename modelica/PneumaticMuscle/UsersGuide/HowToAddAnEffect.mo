within PneumaticMuscle.UsersGuide;
class HowToAddAnEffect "One file, one physical effect"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<ol>
<li>Choose the interface by what the effect does: a force in parallel with the muscle extends
<a href=\"modelica://PneumaticMuscle.Interfaces.ForceEffect\">Interfaces.ForceEffect</a> and gives the equation of
<code>f</code>; gas that leaves extends
<a href=\"modelica://PneumaticMuscle.Interfaces.GasPortEffect\">Interfaces.GasPortEffect</a>; a law that takes the place
of another extends the constraining class of that place
(<a href=\"modelica://PneumaticMuscle.Interfaces.Gas\">Interfaces.Gas</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.ValveDrive\">ValveDrive</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.ValveArea\">ValveArea</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Line\">Line</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Braid\">Braid</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Thermometer\">Thermometer</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Manometer\">Manometer</a>, a measuring channel such as
<a href=\"modelica://PneumaticMuscle.Interfaces.PositionChannel\">PositionChannel</a>, ...) and
<a href=\"modelica://PneumaticMuscle.Interfaces.Effect\">Interfaces.Effect</a>.</li>
<li>Put it into the package of its family: <code>extends FamilyMember(final absent=...)</code> says family and balance,
and for a force or a leak the interface too; <code>absent</code> lists the parameter values at which it vanishes.
Outside the library it extends
<a
href=\"modelica://PneumaticMuscle.Effects.Elasticity.FamilyMember\">PneumaticMuscle.Effects.Elasticity.FamilyMember</a>,
or says a <code>family</code> of its own.</li>
<li>Give every parameter that a measurement is to tell a unit, a minimum, a maximum and a typical value; where a
standard or a data sheet says what is typical, the annotation <code>__PamCosim(typical={low, high})</code>, which is a
prior.</li>
<li>Use expressions with finite derivatives: <code>tanh</code> for a sign,
<a href=\"modelica://PneumaticMuscle.Functions.smoothMax\">Functions.smoothMax</a> for a corner.</li>
<li>Write equation, source, typical values and fingerprint (what a measurement shows) into the documentation.</li>
</ol>
<p><a href=\"modelica://PneumaticMuscle.Examples.ElasticButyl\">Examples.ElasticButyl</a> shows an effect connected by
hand.</p>
</html>"));
end HowToAddAnEffect;

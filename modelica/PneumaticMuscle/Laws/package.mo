within PneumaticMuscle;
package Laws "The base model's own laws, and those that the papers review in their places"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>One package for each kind of law; all classes of a kind have one signature, the interface that they extend, and
are selected by redeclaration: <code>muscle(redeclare model Braid = Laws.Forces.TothovaPitel)</code>.</p>
<table>
<tr><th>kind</th><th>signature</th><th>classes</th></tr>
<tr><td>force</td><td>Interfaces.Braid</td><td>Laws.Forces; the default is
<a href=\"modelica://PneumaticMuscle.Laws.Forces.CylindricalBraid\">CylindricalBraid</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1);
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.TonduEnds\">TonduEnds</a>,
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.KangEnds\">KangEnds</a> and
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.KerscherEnds\">KerscherEnds</a> of Effects.EndShape are laws of
this kind, written with the parameters that a measurement can tell apart</td></tr>
<tr><td>elasticity of the sleeve</td><td>Interfaces.SleeveElasticity</td><td>Laws.Elasticities,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (12)</td></tr>
<tr><td>friction</td><td>Interfaces.ForceElement</td><td>Laws.Frictions, and the members of Effects.DryFriction and
Effects.RateFriction, DP (12)</td></tr>
<tr><td>bladder</td><td>Interfaces.ForceElement</td><td>the members of Effects.Elasticity, such as
<a href=\"modelica://PneumaticMuscle.Effects.Elasticity.YoungBladder\">YoungBladder</a> (Ferraresi) and
<a href=\"modelica://PneumaticMuscle.Effects.Elasticity.MooneyRivlinBladder\">MooneyRivlinBladder</a> (Wang)</td></tr>
<tr><td>gas</td><td>Interfaces.Gas</td><td>Laws.Gases</td></tr>
<tr><td>heat</td><td>Interfaces.Wall, Surroundings, FrictionHeat</td><td>Laws.Heat</td></tr>
<tr><td>dynamics of the valves</td><td>Interfaces.ValveDrive</td><td>Laws.Valves.ImmediateDrive</td></tr>
<tr><td>opening of the valves</td><td>Interfaces.ValveArea</td><td>Laws.Valves.LinearArea, DP (62);
<a href=\"modelica://PneumaticMuscle.Laws.Valves.IttoKogiso\">IttoKogiso</a>, DP (8)</td></tr>
<tr><td>flow through an opening</td><td>Laws.Flows.Flow</td><td>Laws.Flows</td></tr>
<tr><td>line</td><td>Interfaces.Line</td><td>Laws.Lines, with the tubes that longer lines are made of</td></tr>
</table>
<p><a href=\"modelica://PneumaticMuscle.Muscles.Components.ReviewedMuscle\">Components.ReviewedMuscle</a> has a place
for a force, a friction, a bladder and a gas.
<a href=\"modelica://PneumaticMuscle.Laws.Forces.NotChosen\">NotChosen</a>, the default there, refuses and says what to
redeclare.</p>
</html>"));
end Laws;

within PneumaticMuscle;
package Laws "The models that the papers review, each in the place of the base model's own law"
  annotation (Documentation(info="<html>
<p>One package for each kind of law; all classes of a kind have one signature, the interface that they extend, and
are selected by redeclaration: <code>muscle(redeclare model Braid = Laws.Forces.TothovaPitel)</code>.</p>
<table>
<tr><th>kind</th><th>signature</th><th>classes</th></tr>
<tr><td>force</td><td>Interfaces.Braid</td><td>Laws.Forces; Effects.TonduEnds, KangEnds and KerscherEnds are the same
laws, written with the parameters that a measurement can tell apart</td></tr>
<tr><td>friction</td><td>Interfaces.ForceElement</td><td>Laws.Frictions; Effects.CoulombFriction, ViscousFriction,
DahlFriction and MaxwellSlipFriction, DP (12)</td></tr>
<tr><td>bladder</td><td>Interfaces.ForceElement</td><td>Effects.LinearBladder, YoungBladder (Ferraresi),
MooneyRivlinBladder (Wang), PolynomialBladder</td></tr>
<tr><td>flow</td><td>Laws.Flows.Flow</td><td>Laws.Flows</td></tr>
<tr><td>opening of the valves</td><td>Interfaces.ValveArea</td><td>Components.LinearArea, DP (62); Laws.Flows.IttoKogiso,
DP (8)</td></tr>
<tr><td>gas</td><td>Interfaces.Gas</td><td>Laws.Gases</td></tr>
</table>
<p><code>Components.ReviewedMuscle</code> has a place for a force, a friction, a bladder and a gas.
<code>NotChosen</code>, the default there, refuses and says what to redeclare.</p>
</html>"));
end Laws;

within PneumaticMuscle.UsersGuide;
class Conventions "Signs, units, names and the shape of a class"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<p><b>Units and signs</b></p>
<ul>
<li>SI units throughout; the types of <a href=\"modelica://PneumaticMuscle.Types\">Types</a> carry them. A quantity of
no unit has <code>unit=\"1\"</code>.</li>
<li>Pressures are absolute inside components (<code>AbsolutePressure</code>); inputs and outputs of benches are gauge
pressures (<code>GaugePressure</code>).</li>
<li>A flow is positive into the component at whose connector it stands. A contraction is positive when the muscle
shortens; a position is positive in the direction of contraction, a pull is a positive force.</li>
<li>An effect's force is positive where it opposes contraction; its heat is positive out of the gas.</li>
</ul>
<p><b>Connectors</b></p>
<ul>
<li><a href=\"modelica://PneumaticMuscle.Interfaces.GasPort\">Interfaces.GasPort</a> (blue, round): p, T; m_flow,
H_flow. Volumes and sources set p and T, resistances set the flows; the two alternate.</li>
<li><a href=\"modelica://PneumaticMuscle.Interfaces.Flange\">Interfaces.Flange</a> (green, square): s; f. It connects
to Modelica.Mechanics.Translational.</li>
<li><a href=\"modelica://PneumaticMuscle.Interfaces.HeatPort\">Interfaces.HeatPort</a> (red, square): T; Q_flow. It
connects to Modelica.Thermal.HeatTransfer.</li>
<li><a href=\"modelica://PneumaticMuscle.Interfaces.Signals\">Interfaces.Signals</a> (triangles, dark blue): inputs and
outputs of benches and parts, readings of sensors. They connect to Modelica.Blocks. An input that a law takes from its
owner, such as the volume of a gas, is a variable with the prefix <code>input</code> and is bound.</li>
</ul>
<p><b>Diagrams</b></p>
<ul>
<li>Every connection is drawn, level or upright, in the colour of its connector; every component has a place that no
other overlaps. Connectors stand on the edge of the icon, at -100 or 100.</li>
<li>The flange <code>flange_a</code> is the load end, at the bottom; <code>flange_b</code> is the fixed end, at the
top. Gas comes from the left.</li>
<li>The frame of an icon has the colour of the balance. A law's frame is white, an effect's is tinted.</li>
</ul>
<p><b>Names</b></p>
<ul>
<li>Classes are nouns in CamelCase, variables and components begin with a small letter. Symbols of the literature stay
as they are: p, T, V, L0, n_g, mu_fb.</li>
<li>A form that bends between the other members of its family is called <code>Flexible...</code>; the one that says
whatever its family can is called <code>General...</code>.</li>
<li>A replaceable model has the name of its place, <code>Gas</code>, and its component the same name in small letters,
<code>gas</code>. Its constraining class is in <a href=\"modelica://PneumaticMuscle.Interfaces\">Interfaces</a>.</li>
</ul>
<p><b>A class</b></p>
<ul>
<li>One class a file, with a description of every class, component and variable. Lines have 120 characters at most.</li>
<li>A parameter has a unit, bounds, a default value and a group of the dialog; where it has no default, its owner gives
it.</li>
<li>What several classes share is a partial model that they extend: of benches in
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses\">Benches.BaseClasses</a>, of components beside them, what a
place asks for in <a href=\"modelica://PneumaticMuscle.Interfaces\">Interfaces</a>.</li>
<li>An equation names its source in the documentation, with the number that it has there; the work is in
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">References</a>. The first mention of a work and every name
of another class are links.</li>
<li>No events: corners, signs and stops are rounded over less than an instrument resolves, and the class says where.
Every expression has finite derivatives.</li>
</ul>
</html>"));
end Conventions;

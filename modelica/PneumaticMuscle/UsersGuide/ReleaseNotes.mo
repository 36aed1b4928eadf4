within PneumaticMuscle.UsersGuide;
class ReleaseNotes "What changed in the library from version to version"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<p>What concerns the library; <code>CHANGELOG.md</code> lists all changes of the software around it.</p>
<p><b>Unreleased</b></p>
<ul>
<li>What several benches share stands once, in
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses\">Benches.BaseClasses</a>; every bench with surroundings
extends <a href=\"modelica://PneumaticMuscle.Interfaces.Rig\">Interfaces.Rig</a>. The muscle of a bench is a replaceable
component: <code>Benches.Isotonic(redeclare Muscles.Components.ButylMuscle muscle)</code>. Names and trajectories are
what they were.</li>
<li>Errors of instruments state what is typical of them in an annotation,
<a href=\"modelica://PneumaticMuscle.Interfaces.Effect\">Interfaces.Effect</a>.</li>
<li>Components stand with the parts that are made of them, in
<a href=\"modelica://PneumaticMuscle.Pneumatics.Components\">Pneumatics.Components</a>,
<a href=\"modelica://PneumaticMuscle.Muscles.Components\">Muscles.Components</a> and
<a href=\"modelica://PneumaticMuscle.Mechanics.Components\">Mechanics.Components</a>; transducers in
<a href=\"modelica://PneumaticMuscle.Instruments.Sensors\">Instruments.Sensors</a>, tables of muscles in
<a href=\"modelica://PneumaticMuscle.Muscles.Data\">Muscles.Data</a>, models of what papers found in
<a href=\"modelica://PneumaticMuscle.Examples.Validation\">Examples.Validation</a>.</li>
<li>Every connection is drawn and every component has its place, also in muscles, valves, vessels and the parts of a
rig. Names of classes and the first mention of a work are links. New pages
<a href=\"modelica://PneumaticMuscle.UsersGuide.Conventions\">Conventions</a> and ReleaseNotes.</li>
<li>Inputs and outputs of benches and parts and readings of sensors are connectors,
<a href=\"modelica://PneumaticMuscle.Interfaces.Signals\">Interfaces.Signals</a>, to which blocks of Modelica.Blocks
connect. Names, equations and results are what they were.</li>
<li>Parts of rigs: <a href=\"modelica://PneumaticMuscle.Pneumatics\">Pneumatics</a>,
<a href=\"modelica://PneumaticMuscle.Mechanics\">Mechanics</a>,
<a href=\"modelica://PneumaticMuscle.Muscles\">Muscles</a> and
<a href=\"modelica://PneumaticMuscle.Instruments\">Instruments</a>; valves that a voltage commands.</li>
<li>Muscles by name, with their measures in <a href=\"modelica://PneumaticMuscle.Muscles.Data\">Data</a>; laws and
effects of fluidic muscles; <code>muscle.V_solid</code>, volume in the sleeve that is no gas.</li>
<li>Benches for points at rest,
<a href=\"modelica://PneumaticMuscle.Benches.QuasiStaticIsometric\">Benches.QuasiStaticIsometric</a> and
<a href=\"modelica://PneumaticMuscle.Benches.QuasiStaticIsotonic\">Benches.QuasiStaticIsotonic</a>.</li>
<li>Effects stand in packages by family; default laws are in <a href=\"modelica://PneumaticMuscle.Laws\">Laws</a>. New
families are faults of instruments, behind replaceable measuring channels and a recorder. Valves have a place behind the
law of their area, <a href=\"modelica://PneumaticMuscle.Interfaces.ValveOpening\">Interfaces.ValveOpening</a>, and one
before the inlet, <a href=\"modelica://PneumaticMuscle.Interfaces.Feed\">Interfaces.Feed</a>.</li>
<li>New effects: fibres that stretch,
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.ElasticBraid\">ElasticBraid</a>; friction by load and frequency,
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.LoadFrequencyFriction\">LoadFrequencyFriction</a>.</li>
<li>The bench in pieces for coupled simulation, and controllers:
<a href=\"modelica://PneumaticMuscle.CoSimulation\">CoSimulation</a>.</li>
<li>What is said of the field in reports is the record
<a href=\"modelica://PneumaticMuscle.Domain\">Domain</a>.</li>
<li>Icons, dialogs in groups, choices for every replaceable model; a bibliography,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">References</a>.</li>
<li><a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.RealGas\">RealGas</a> and
<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.GeneralGas\">GeneralGas</a> balance energy for every share e;
their films and that of <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.FlexibleGas\">FlexibleGas</a> are meant
at ambient pressure and temperature, also in a vessel that starts elsewhere.
<a href=\"modelica://PneumaticMuscle.Muscles.AirMuscle\">Muscles.AirMuscle</a> has no friction, and
<a href=\"modelica://PneumaticMuscle.Muscles.AnyGeometry\">AnyGeometry</a> has as many fibres as its sleeve takes,
unless they are stated. All muscles of DP warn of fibres that do not fit on them.</li>
</ul>
<p><b>0.1.0</b></p>
<ul>
<li>The models of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>, of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> and of the papers that they review; 78 effects in 16
families.</li>
</ul>
</html>"));
end ReleaseNotes;

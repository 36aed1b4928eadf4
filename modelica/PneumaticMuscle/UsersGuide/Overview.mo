within PneumaticMuscle.UsersGuide;
class Overview "What is where"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<p>A <b>bench</b> (<a href=\"modelica://PneumaticMuscle.Benches\">Benches</a>) is a test rig: its inputs are what is
driven, its outputs what instruments read. Both are connectors of
<a href=\"modelica://PneumaticMuscle.Interfaces.Signals\">Interfaces.Signals</a>, to which blocks connect. Pressures are
absolute inside the components and gauge pressures in the signals of a bench.</p>
<p>A bench of one's own is put together from parts by <code>pam-cosim bench</code>: one of
<a href=\"modelica://PneumaticMuscle.Pneumatics\">Pneumatics</a> that feeds the muscle, one of
<a href=\"modelica://PneumaticMuscle.Muscles\">Muscles</a>, one of
<a href=\"modelica://PneumaticMuscle.Mechanics\">Mechanics</a> that it pulls, and
<a href=\"modelica://PneumaticMuscle.Instruments\">Instruments</a>.</p>
<p>Benches and parts are made of <b>components</b>:
<a href=\"modelica://PneumaticMuscle.Pneumatics.Components\">Pneumatics.Components</a>,
<a href=\"modelica://PneumaticMuscle.Muscles.Components\">Muscles.Components</a>,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components\">Mechanics.Components</a> and
<a href=\"modelica://PneumaticMuscle.Instruments.Sensors\">Instruments.Sensors</a>. Every law of a load, a valve or a
vessel stands in one of them. What several benches have in common, valves with their supply, a muscle that hangs, each
reading with its channel, stands once in
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses\">Benches.BaseClasses</a>, and a bench extends what it needs:
so its components have the short names that data sets and fitted models say, <code>load.m</code> or
<code>thermometer.tau</code>. In a rig that is put together from parts, which may hold several muscles, these are names
inside a part, <code>temperature.thermometer.tau</code>. Both have the same frame,
<a href=\"modelica://PneumaticMuscle.Interfaces.Rig\">Interfaces.Rig</a>, components and equations. Around all is an
<a href=\"modelica://PneumaticMuscle.Ambient\">Ambient</a>. Gas flows through
<a href=\"modelica://PneumaticMuscle.Interfaces.GasPort\">Interfaces.GasPort</a>: volumes and sources set pressure and
temperature, resistances set mass and enthalpy flow; the two alternate. Muscles end in
<a href=\"modelica://PneumaticMuscle.Interfaces.Flange\">Interfaces.Flange</a> as the Modelica Standard Library has it,
positive in contraction.</p>
<p>Where the papers differ, a component has a replaceable law with a constraining class: the <code>Gas</code>, the
<code>Wall</code> and the <code>Braid</code> of a muscle, the <code>Drive</code> and the <code>Area</code> of the
valves, the instruments of a bench with the measuring channels behind them and the clock of the record.
<a href=\"modelica://PneumaticMuscle.Laws\">Laws</a> holds those that the papers review,
<a href=\"modelica://PneumaticMuscle.Effects\">Effects</a> those that a diagnosis tries on a measurement.</p>
<p>How what is stored begins is said by the parameter <code>dynamics</code>, of every class with states and, for all
of a bench at once, of its <code>ambient</code>, in the words of Modelica.Fluid: <code>FixedInitial</code>, with the
start values (usual: no pressure, shut valves, a load on its stop; what follows something begins where that is);
<code>SteadyStateInitial</code>, at rest under the first inputs, sought from the start values, the valves as their
currents have them; <code>DynamicFreeInitial</code>, as nothing else says, from the start values. So
<code>Benches.Isotonic(ambient(dynamics=Types.Dynamics.SteadyStateInitial))</code> begins under the pressure that its
open valves hold. Dry friction rests anywhere: it begins at its start values unless they are free.</p>
<p>No model has events. Corners, signs and stops are rounded over less than an instrument resolves; where, is said
in the class. All expressions have finite derivatives throughout the range of operation.</p>
<p>Two laws of the base model contradict each other as printed: the energy balance
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (59) and the polytropic temperature DP (60). The
base model keeps both, since that is the published model;
<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a> mends it.</p>
</html>"));
end Overview;

package PneumaticMuscle
  "Pneumatic artificial muscles, their valves and vessels, and the effects that simple models leave out"
  extends Icons.Package;
  annotation (version="0.1.0", Documentation(info="<html>
<p>Acausal models of pneumatic artificial muscles (McKibben muscles). Inside the models pressures are
absolute; the signals of a bench are what instruments read, gauge pressures.</p>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> and
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a> are cited by equation number, other works by authors
and year; <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">UsersGuide.References</a> lists them all.</p>
<p>A class of <a href=\"modelica://PneumaticMuscle.Effects\">Effects</a> is one physical effect that the base model
lacks, in the package of its family. Where it attaches is said
by the interface it extends:</p>
<ul>
<li>it extends <a href=\"modelica://PneumaticMuscle.Interfaces.ForceEffect\">Interfaces.ForceEffect</a> or
<a href=\"modelica://PneumaticMuscle.Interfaces.GasPortEffect\">Interfaces.GasPortEffect</a>, or has otherwise the same
terminals as a component of the bench
(<a href=\"modelica://PneumaticMuscle.Interfaces.MuscleTerminals\">Interfaces.MuscleTerminals</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.VesselTerminals\">Interfaces.VesselTerminals</a>): it is connected in
parallel with that component, terminal by terminal, and takes over the parameters that the terminals declare;</li>
<li>it extends the constraining class of a replaceable model
(<a href=\"modelica://PneumaticMuscle.Interfaces.Gas\">Interfaces.Gas</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Wall\">Interfaces.Wall</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Surroundings\">Interfaces.Surroundings</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.FrictionHeat\">Interfaces.FrictionHeat</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Braid\">Interfaces.Braid</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.ValveDrive\">Interfaces.ValveDrive</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.ValveArea\">Interfaces.ValveArea</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Line\">Interfaces.Line</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Thermometer\">Interfaces.Thermometer</a>,
<a href=\"modelica://PneumaticMuscle.Interfaces.Manometer\">Interfaces.Manometer</a>): it is redeclared there.</li>
</ul>
<p>An effect says in <code>absent</code> at which values of its parameters the base model is left.</p>
</html>"));
end PneumaticMuscle;

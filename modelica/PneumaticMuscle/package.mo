package PneumaticMuscle "Pneumatic artificial muscles, their valves and vessels, and the effects that simple models leave out"
  extends Icons.Package;
  annotation (version="0.1.0", Documentation(info="<html>
<p>Acausal models of pneumatic artificial muscles (McKibben muscles). Inside the models pressures are
absolute; the signals of a bench are what instruments read, gauge pressures.</p>
<p>DP, DY and AM are cited by equation number, other works by authors and year; <code>UsersGuide.References</code>
lists them all.</p>
<p>A class of <code>Effects</code> is one physical effect that the base model lacks, in the package of its family. Where
it attaches is said
by the interface it extends:</p>
<ul>
<li>it extends <code>Interfaces.ForceEffect</code> or <code>Interfaces.GasPortEffect</code>, or has otherwise the same
terminals as a component of the bench (<code>Interfaces.MuscleTerminals</code>, <code>Interfaces.VesselTerminals</code>): it is connected in parallel
with that component, terminal by terminal, and takes over the parameters that the terminals declare;</li>
<li>it extends the constraining class of a replaceable model (<code>Interfaces.Gas</code>,
<code>Interfaces.Wall</code>, <code>Interfaces.Surroundings</code>, <code>Interfaces.FrictionHeat</code>,
<code>Interfaces.Braid</code>, <code>Interfaces.ValveDrive</code>, <code>Interfaces.ValveArea</code>,
<code>Interfaces.Line</code>, <code>Interfaces.Thermometer</code>, <code>Interfaces.Manometer</code>): it is redeclared
there.</li>
</ul>
<p>An effect says in <code>absent</code> at which values of its parameters the base model is left.</p>
</html>"));
end PneumaticMuscle;

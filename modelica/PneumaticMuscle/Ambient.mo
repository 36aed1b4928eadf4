within PneumaticMuscle;
model Ambient "The surroundings of a bench"
  extends Icons.Surroundings;
  parameter Types.AbsolutePressure p(min=5e4, max=1.2e5) = 101325 "Ambient pressure"
    annotation (Dialog(group="Surroundings"));
  parameter Types.Temperature T(min=250, max=330) = 293.15 "Ambient temperature"
    annotation (Dialog(group="Surroundings"));
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initialization of all components that do not state their own"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  input Real branch(unit="1") = 0 "Direction of a motion too slow to have a speed: 1 contraction, -1 extension, 0 none";
  annotation (defaultComponentName="ambient", defaultComponentPrefixes="inner",
    missingInnerMessage="This model has no surroundings: add an Ambient, declared inner, at its top level.",
    Documentation(info="<html>
<p>Pressure and temperature of the air around a bench; declared <code>inner</code> in the bench and <code>outer</code>
in what needs it. 101 325 Pa and 293.15 K unless known better.</p>
<p><code>dynamics</code> says how all around it begins:
<a href=\"modelica://PneumaticMuscle.Types.Dynamics\">Types.Dynamics</a>. A component
may say otherwise of itself.</p>
<p>Quasi-static measurements have no speed but may have a direction, that of their branch: dry friction takes its sign
from it, <a href=\"modelica://PneumaticMuscle.Interfaces.ForceElement\">Interfaces.ForceElement</a>. In time it is
zero.</p>
</html>"));
end Ambient;

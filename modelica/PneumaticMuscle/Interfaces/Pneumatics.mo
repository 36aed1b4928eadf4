within PneumaticMuscle.Interfaces;
partial model Pneumatics "What feeds the gas port of a muscle"
  extends RigPart;
  GasPort port "Gas port of the muscle"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: pressure or flow at the port, and what is told from outside as <code>input</code>.</p>
</html>"));
end Pneumatics;

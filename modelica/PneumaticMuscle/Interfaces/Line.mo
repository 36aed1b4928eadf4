within PneumaticMuscle.Interfaces;
partial model Line "What lies between the valves and the muscle or vessel"
  extends Icons.Line;
  GasPort port_a "Valve end"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  GasPort port_b "Muscle or vessel end"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: four equations between the two ends, for pressure, temperature, mass and enthalpy
flow.</p>
</html>"));
end Line;

within PneumaticMuscle.Interfaces;
partial model Feed "What lies between the supply and the inlet valve"
  extends Icons.Line;
  GasPort port_a "Supply end"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  GasPort port_b "End at the inlet valve"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: four equations between the two ends, for pressure, temperature, mass and enthalpy
flow. <a href=\"modelica://PneumaticMuscle.Interfaces.Line\">Interfaces.Line</a> lies behind the valves, where what is
vented passes too.</p>
</html>"));
end Feed;

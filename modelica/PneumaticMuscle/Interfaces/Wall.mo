within PneumaticMuscle.Interfaces;
partial model Wall "What stands between the gas and what is outside"
  extends Icons.Wall;
  HeatPort heatPort "Gas side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  HeatPort outside "Outer side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  input Types.Area A "Area that exchanges heat";
  input Types.CoefficientOfHeatTransfer h_film "Film coefficient";
  parameter Types.ThermalConductivity k "Thermal conductivity" annotation (Dialog(group="Heat"));
  parameter Types.Length t "Thickness" annotation (Dialog(group="Geometry"));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: two equations between temperatures and heat flows of the two sides.</p>
</html>"));
end Wall;

within PneumaticMuscle.Interfaces;
partial model Wall "What stands between the gas and what is outside"
  HeatPort heatPort "Gas side";
  HeatPort outside "Outer side";
  input Types.Area A "Area that exchanges heat";
  input Types.CoefficientOfHeatTransfer h_film "Film coefficient";
  parameter Types.ThermalConductivity k "Thermal conductivity" annotation (Dialog(group="Heat"));
  parameter Types.Length t "Thickness" annotation (Dialog(group="Geometry"));
  annotation (Documentation(info="<html>
<p>Left to the extending class: two equations between temperatures and heat flows of the two sides.</p>
</html>"));
end Wall;

within PneumaticMuscle.Interfaces;
partial model Wall "What stands between the gas and the surroundings"
  HeatPort heatPort "Gas side";
  input Types.Area A "Area that exchanges heat";
  input Types.CoefficientOfHeatTransfer h_film "Film coefficient";
  parameter Types.ThermalConductivity k "Thermal conductivity";
  parameter Types.Length t "Thickness";
  outer Components.Ambient ambient "Surroundings";
end Wall;

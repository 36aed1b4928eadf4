within Bioreactor.Interfaces;
connector Broth "A stirred liquid: the same concentrations everywhere"
  Real S(unit="kg/m3") "Concentration of the substrate";
  Real X(unit="kg/m3") "Concentration of the biomass, dry";
  Real V(unit="m3") "Volume";
  flow Real m_S(unit="kg/s") "Substrate into the part";
  flow Real m_X(unit="kg/s") "Biomass into the part";
  flow Real q(unit="m3/s") "Liquid into the part";
end Broth;

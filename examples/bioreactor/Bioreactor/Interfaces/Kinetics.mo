within Bioreactor.Interfaces;
partial model Kinetics "Specific rate of growth; left open: the equation of mu"
  input Real S(unit="kg/m3") "Concentration of the substrate";
  input Real X(unit="kg/m3") "Concentration of the biomass";
  parameter Real mu_max(unit="1/s", min=0) "Rate of growth that the law refers to";
  Real mu(unit="1/s") "Specific rate of growth";
end Kinetics;

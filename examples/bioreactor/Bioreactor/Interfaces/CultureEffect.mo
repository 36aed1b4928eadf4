within Bioreactor.Interfaces;
partial model CultureEffect "An effect in parallel to the culture; left open: the equations of r_S and r_X"
  extends Culture;
  extends Effect;
  Real S(unit="kg/m3") "Concentration of the substrate";
  Real X(unit="kg/m3") "Concentration of the biomass";
  Real r_S(unit="kg/(m3.s)") "Substrate that is consumed";
  Real r_X(unit="kg/(m3.s)") "Biomass that is lost";
equation
  S = broth.S;
  X = broth.X;
  broth.m_S = r_S*broth.V;
  broth.m_X = r_X*broth.V;
  broth.q = 0;
end CultureEffect;

within Bioreactor.Unknowns;
partial model UptakeTerm "A further consumption of substrate; left open: the equation of missing"
  extends Interfaces.CultureEffect(final balance="substrate");
  Real missing(unit="kg/(m3.s)") "Substrate that is consumed";
equation
  r_S = missing;
  r_X = 0;
end UptakeTerm;

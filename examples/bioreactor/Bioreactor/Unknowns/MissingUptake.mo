within Bioreactor.Unknowns;
model MissingUptake "A consumption of substrate that no law explains"
  extends UptakeTerm(final family="unknown", final absent="r_missing=0");
  parameter Real r_missing(unit="kg/(m3.s)", min=-1, max=1) = 0 "Missing consumption";
equation
  missing = r_missing;
end MissingUptake;

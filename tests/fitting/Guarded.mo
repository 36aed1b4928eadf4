model Guarded "Decay that states itself where it is valid"
  parameter Real a(min=0, max=100) = 2 "Rate";
  parameter Real limit = 6 "Above it the model is not valid";
  Real s(start=1, fixed=true);
  output Real y;
equation
  assert(time < 0.25 or -der(s)/s < limit, "too fast at s = " + String(s));
  der(s) = -a*s;
  y = s*sqrt(abs((limit - a)/(limit - 2)));
end Guarded;

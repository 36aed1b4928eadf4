model Wall "Decay that breaks down where it is fast"
  parameter Real a(min=0, max=100) = 2 "Rate";
  parameter Real limit = 6 "Above it there is no answer";
  Real s(start=1, fixed=true, nominal=1);
  output Real y;
equation
  der(s) = -a*s;
  y = s + 1e-9*sqrt(limit - a);
end Wall;

model Fragile "Decay whose output exists only while the rate is below a limit"
  parameter Real a(min=0, max=100) = 2 "Rate";
  parameter Real limit = 6 "Above it the root is of a negative number";
  Real s(start=1, fixed=true);
  output Real y;
equation
  der(s) = -a*s;
  y = s*sqrt((limit - a)/(limit - 2));
end Fragile;

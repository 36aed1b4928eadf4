model Decay "Decay with a rate that may be of any order of magnitude"
  parameter Real a(min=0, max=1e6) = 1 "Rate";
  Real s(start=1, fixed=true);
  output Real y;
equation
  der(s) = -a*s;
  y = s;
end Decay;

model TooMany
  Real x(start=0, fixed=true);
equation
  der(x) = -x;
  x = 5;
end TooMany;

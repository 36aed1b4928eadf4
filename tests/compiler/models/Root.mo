model Root
  Real x(start=1, fixed=true);
  Real root;
equation
  der(x) = -root;
  root^3 + root = x;
end Root;

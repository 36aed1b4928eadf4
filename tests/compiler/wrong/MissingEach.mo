model MissingEach
  Real x[2](start=1, each fixed=true);
equation
  der(x) = -x;
end MissingEach;

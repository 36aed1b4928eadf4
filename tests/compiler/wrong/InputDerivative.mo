model InputDerivative
  input Real position;
  Real s, v;
equation
  s = 2*position;
  v = der(s);
end InputDerivative;

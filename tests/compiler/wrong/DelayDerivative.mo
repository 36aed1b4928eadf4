model DelayDerivative
  input Real u;
  Real y;
equation
  y = der(delay(u, 0.1));
end DelayDerivative;

model DelayNegative
  input Real u;
  Real y;
equation
  y = delay(u, -0.5);
end DelayNegative;

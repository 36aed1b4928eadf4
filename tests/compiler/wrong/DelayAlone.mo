model DelayAlone
  input Real u;
  Real y;
equation
  y = delay(u);
end DelayAlone;

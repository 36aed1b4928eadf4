model DelayDifferentiated
  input Real u;
  Real s = delay(u, 0.1);
  Real v = der(s);
end DelayDifferentiated;

model DelayOfItself
  input Real u;
  Real y, z;
equation
  y = u + delay(z, 0.1);
  z = delay(y, 0.1);
end DelayOfItself;

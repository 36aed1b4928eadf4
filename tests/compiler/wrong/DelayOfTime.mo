model DelayOfTime
  input Real u;
  Real y = delay(u*time, 0.1);
end DelayOfTime;

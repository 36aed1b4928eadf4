model DelayVaries
  input Real u;
  Real T = 1 + u^2;
  Real y;
equation
  y = 3 + delay(u, T, 2);
end DelayVaries;

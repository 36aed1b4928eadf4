model DelayInitial
  input Real u;
  Real x;
initial equation
  x = delay(u, 0.1);
equation
  der(x) = -x;
end DelayInitial;

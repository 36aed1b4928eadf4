model DelayOfState
  parameter Real T = 0.1;
  input Real u;
  Real x(start=0, fixed=true);
equation
  der(x) = u - delay(2*x, T);
end DelayOfState;

model Gain "First-order lag whose end value is the gain times the input"
  parameter Real k(min=0, max=100) = 1 "Gain";
  parameter Real b = 0 "Bias, without bounds";
  parameter Real tau(min=0.01, max=10) = 0.1 "Time constant in seconds";
  input Real u;
  Real s(start=0, fixed=true) "State";
  output Real y "Reading";
equation
  tau*der(s) = k*u + b - s;
  y = s;
end Gain;

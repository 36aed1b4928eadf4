package Delays "Inputs as they were some time ago"
  model DeadTime
    input Real u[2];
    Real y[2];
    parameter Real T = 0.2;
  equation
    for i in 1:2 loop
      y[i] = delay(u[i], T);
    end for;
  end DeadTime;

  model Uses "Through aliases, arrays, expressions and other delays"
    input Real a, b;
    parameter Real k = 3;
    DeadTime drive(u={a, -b}, T=0.5*k);
    Real mixed = delay(k*a + b^2, 0.5*k, 10);
    Real later = delay(drive.y[1], 1);
    Real known = delay(4.0, 1);
    Real switched = delay(if initial() then k else a + 1, 0.5*k);
    Real again = delay(switched, 2);
    output Real y = drive.y[1] + drive.y[2];
    Real x(start=0, fixed=true);
  equation
    der(x) = mixed - a*x;
  end Uses;
end Delays;

within DCMotor.Components;
model Drum "A drum that winds up a rope with a weight"
  Interfaces.Flange shaft "Shaft";
  parameter Real m(unit="kg", min=0, max=100) = 1 "Mass of the weight";
  parameter Real r(unit="m", min=1e-3, max=1) = 0.02 "Radius of the drum";
  Real w(unit="rad/s") "Speed";
  constant Real g(unit="m/s2") = 9.81 "Acceleration of gravity";
equation
  w = der(shaft.phi);
  shaft.tau = m*r*(r*der(w) + g);
end Drum;

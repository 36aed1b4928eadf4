within DCMotor.Components;
model Flywheel "Inertia of rotor and load, at rest at the start"
  Interfaces.Flange shaft(phi(start=0, fixed=true)) "Shaft";
  parameter Real J(unit="kg.m2", min=1e-7, max=1) = 2e-4 "Moment of inertia";
  Real w(unit="rad/s", start=0, fixed=true) "Speed";
equation
  w = der(shaft.phi);
  J*der(w) = shaft.tau;
end Flywheel;

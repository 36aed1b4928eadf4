within WindTunnel.Components;
model Rotor "Inertia of a fan"
  Interfaces.Shaft shaft(w(start=w_start, fixed=true)) "Shaft";
  parameter Real I(unit="kg.m2", min=1e-6, max=1e-2) = 3.481e-5 "Moment of inertia; the authors': a disk of 20 g and 59 mm";
  parameter Real w_start(unit="rad/s", min=0, max=1000) = 31.4 "Speed at the start";
equation
  I*der(shaft.w) = shaft.tau;
end Rotor;

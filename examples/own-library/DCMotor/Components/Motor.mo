within DCMotor.Components;
model Motor "Permanent-magnet motor: resistance, inductance, induced voltage, viscous friction"
  extends Interfaces.MotorTerminals(mesh(i(start=0, fixed=true)));
  parameter Real R(unit="Ohm", min=0.01, max=100) = 1 "Resistance of the armature";
  parameter Real L(unit="H", min=1e-6, max=1) = 1e-3 "Inductance of the armature";
  parameter Real k(unit="V.s/rad", min=1e-4, max=10) = 0.05 "Induced voltage over speed, torque over current";
  parameter Real b(unit="N.m.s/rad", min=0, max=1e-2) = 2e-5 "Viscous friction";
  replaceable model Winding = ConstantWinding constrainedby Interfaces.Winding "Resistance" annotation (choicesAllMatching=true);
  Winding winding(R_cold=R, i=mesh.i) "Resistance";
protected
  Real w(unit="rad/s") "Speed";
equation
  w = der(shaft.phi);
  mesh.v = winding.R*mesh.i + L*der(mesh.i) + k*w;
  shaft.tau = b*w - k*mesh.i;
end Motor;

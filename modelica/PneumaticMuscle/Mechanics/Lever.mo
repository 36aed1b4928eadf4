within PneumaticMuscle.Mechanics;
model Lever "A mass on a lever that the muscle lifts"
  extends Interfaces.Mechanics(shows="x", final F_start=m*Constants.g*l/r);
  extends Icons.Load;
  Interfaces.Flange flange "Load end of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Types.Length r(min=1e-3, max=10) = 0.15 "From the pivot to the muscle"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length l(min=1e-3, max=10) = 0.3 "From the pivot to the mass" annotation (Dialog(group="Geometry"));
  parameter Types.Mass m(min=0.001, max=1000) = 1.5 "Mass" annotation (Dialog(group="Load"));
  parameter Real J(unit="kg.m2", min=0, max=100) = 1e-3 "Moment of inertia of the lever"
    annotation (Dialog(group="Load"));
  parameter Real d(unit="N.m.s/rad", min=0, max=100) = 0.1 "Bearing friction" annotation (Dialog(group="Mechanics"));
  Real phi(unit="rad", displayUnit="deg", start=asin(x_start/r), fixed=dynamics == Types.Dynamics.FixedInitial)
    "Angle, zero where the lever is level";
  Real w(unit="rad/s", start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Angular velocity";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(phi) = 0;
    der(w) = 0;
  end if;
equation
  assert(phi > -1.5 and phi < 1.5, "the lever is upright: the muscle contracts by more than its arm r");
  flange.s = r*sin(phi);
  w = der(phi);
  (J + m*l^2)*der(w) = (r*flange.f - l*m*Constants.g)*cos(phi) - d*w;
  annotation (Documentation(info="<html>
<p>(J + m l^2) phi_ddot = (r F - l m g) cos(phi) - d phi_dot, with the contraction r sin(phi): Newton's law about the
pivot of a lever that is level while the muscle is at its length at rest, and to which the muscle stays upright (its own
tilt is left out). The lever itself has a moment of inertia and no weight: it is balanced about its pivot. Values are
for illustration.</p>
</html>"));
end Lever;

within PneumaticMuscle.Mechanics;
model Platform "A platform that three muscles carry"
  extends Interfaces.Mechanics(shows="x", final F_start=m*Constants.g/3);
  extends Icons.Load;
  Interfaces.Flange flange_1 "First muscle"
    annotation (Placement(transformation(extent={{-70,90},{-50,110}})));
  Interfaces.Flange flange_2 "Second muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Flange flange_3 "Third muscle"
    annotation (Placement(transformation(extent={{50,90},{70,110}})));
  parameter Types.Mass m(min=0.001, max=1000) = 6 "Mass" annotation (Dialog(group="Load"));
  parameter Types.Length r(min=1e-3, max=10) = 0.1 "From the middle to each muscle"
    annotation (Dialog(group="Geometry"));
  parameter Real J(unit="kg.m2", min=1e-6, max=100) = 0.03 "Moment of inertia about each level axis"
    annotation (Dialog(group="Load"));
  parameter Real d(unit="N.m.s/rad", min=0, max=100) = 0.1 "Damping of a tilt" annotation (Dialog(group="Mechanics"));
  Types.Length s(start=x_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Height of the middle";
  Types.Velocity v(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Its speed";
  Real a(unit="rad", displayUnit="deg", start=0, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Tilt towards the first muscle";
  Real b(unit="rad", displayUnit="deg", start=0, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Tilt towards the second and away from the third";
  Real w_a(unit="rad/s", start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Rate of the first tilt";
  Real w_b(unit="rad/s", start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Rate of the second tilt";
protected
  constant Real half = sqrt(3)/2 "Arm of the second and the third muscle about the other axis, by r";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(s) = 0;
    der(v) = 0;
    der(a) = 0;
    der(b) = 0;
    der(w_a) = 0;
    der(w_b) = 0;
  end if;
equation
  flange_1.s = s + r*a;
  flange_2.s = s + r*(half*b - a/2);
  flange_3.s = s - r*(half*b + a/2);
  v = der(s);
  w_a = der(a);
  w_b = der(b);
  m*der(v) = flange_1.f + flange_2.f + flange_3.f - m*Constants.g;
  J*der(w_a) = r*(flange_1.f - (flange_2.f + flange_3.f)/2) - d*w_a;
  J*der(w_b) = r*half*(flange_2.f - flange_3.f) - d*w_b;
  annotation (Documentation(info="<html>
<p>Newton's and Euler's laws of a plate that hangs level on three muscles in an equal-sided triangle, for small tilts:
m s_ddot = F_1 + F_2 + F_3 - m g, J a_ddot = r (F_1 - (F_2 + F_3)/2) - d a_dot,
J b_ddot = r sqrt(3)/2 (F_2 - F_3) - d b_dot. The three contractions say height and both tilts. Values are for
illustration.</p>
</html>"));
end Platform;

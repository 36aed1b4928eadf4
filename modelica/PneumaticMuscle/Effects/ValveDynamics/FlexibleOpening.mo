within PneumaticMuscle.Effects.ValveDynamics;
model FlexibleOpening "The openings follow late, by a dead time, a lag and at a limited rate, up and down alike or not"
  extends Interfaces.ValveOpening(
    A(each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial, each nominal=1e-7));
  extends FamilyMember(final absent="tau=1e-6, travel=1e-6, ratio=1, dead_time=1e-6");
  parameter Types.Time tau(min=1e-6, max=2, nominal=0.05) = 0.03 "Time constant of opening"
    annotation (Dialog(group="Effect"));
  parameter Types.Time travel(min=1e-6, max=2, nominal=0.05) = 0.01
    "Time for opening from shut to 3.69e-7 m2 at the maximum rate"
    annotation (Dialog(group="Effect"));
  parameter Real ratio(unit="1", min=0.05, max=20, nominal=1) = 1 "Both times of closing, by those of opening"
    annotation (Dialog(group="Effect"));
  parameter Types.Time dead_time(min=1e-6, max=2, nominal=0.05) = 0.01 "Dead time" annotation (Dialog(group="Effect"));
protected
  parameter Types.Time t_0(fixed=false) "Start time";
  constant Types.Area A_reference = 3.69e-7 "Area of DP (62) at 0.35 A, before the factor C_A, to which travel refers";
  constant Types.Area A_smooth = 4e-9 "Difference of areas over which opening and closing change roles";
  Types.Area d[2](each nominal=1e-7) "What the openings still lack";
  Real by[2](each unit="1") "Factor on both times: 1 in opening, ratio in closing";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(A) = zeros(2);
  end if;
  t_0 = time;
equation
  for i in 1:2 loop
    d[i] = (if dynamics == Types.Dynamics.SteadyStateInitial or
      time > t_0 + dead_time then delay(A_set[i], dead_time) else 0) - A[i];
    by[i] = 0.5*(1 + ratio) + 0.5*(1 - ratio)*d[i]/sqrt(d[i]^2 + A_smooth^2);
    by[i]*sqrt(tau^2 + (travel*d[i]/A_reference)^2)*der(A[i]) = d[i];
  end for;
  annotation (Documentation(info="<html>
<p>A_dot = d/sqrt(tau^2 + (travel d/A_0)^2), d = A_set(t - dead_time) - A, A_0 = 3.69e-7 m2, for either valve; where d
is negative, A_dot is divided by ratio:
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.FlexibleDrive\">FlexibleDrive</a> behind the law of the area.
Source: see there, <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.OpeningLag\">OpeningLag</a> and
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.OpeningRateLimit\">OpeningRateLimit</a>; a plunger is opened
by the magnet and shut by its spring, each in its own time. Typical 5 to 100 ms each, ratio 0.3 to 3. Both valves are
shut before the start.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.OpeningLag\">OpeningLag</a>, later in
closing than in opening or the other way round.</p>
</html>"));
end FlexibleOpening;

within PneumaticMuscle.Effects.ValveDynamics;
model FlexibleDrive "The valves follow late, by a dead time, by lags and at a limited rate, up and down alike or not"
  extends Interfaces.ValveDrive(y(each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="tau=1e-6, slew=1e-6, ratio=1, tau_coil=1e-6, dead_time=1e-6");
  parameter Types.Time tau(min=1e-6, max=2, nominal=0.05) = 0.03 "Time constant of opening"
    annotation (Dialog(group="Effect"));
  parameter Types.Time slew(min=1e-6, max=2, nominal=0.05) = 0.01
    "Time for 0.35 A at the maximum rate"
    annotation (Dialog(group="Effect"));
  parameter Real ratio(unit="1", min=0.05, max=20, nominal=1) = 1 "Both times of closing, by those of opening"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau_coil(min=1e-6, max=2, nominal=0.05) = 0.01 "Time constant of the coil"
    annotation (Dialog(group="Effect"));
  parameter Types.Time dead_time(min=1e-6, max=2, nominal=0.05) = 0.02 "Dead time" annotation (Dialog(group="Effect"));
  Types.Current c[2](each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial) "Currents of the coils";
protected
  parameter Types.Time t_0(fixed=false) "Start time";
  constant Types.Current u_reference = 0.35 "Current to which slew refers";
  constant Types.Current u_smooth = 5e-3 "Difference of currents over which opening and closing change roles";
  Types.Current d[2] "What the currents that are felt still lack";
  Real by[2](each unit="1") "Factor on both times: 1 in opening, ratio in closing";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(c) = zeros(2);
    der(y) = zeros(2);
  end if;
  t_0 = time;
equation
  for i in 1:2 loop
    tau_coil*der(c[i]) = (if dynamics == Types.Dynamics.SteadyStateInitial or
      time > t_0 + dead_time then delay(u[i], dead_time) else 0) - c[i];
    d[i] = c[i] - y[i];
    by[i] = 0.5*(1 + ratio) + 0.5*(1 - ratio)*d[i]/sqrt(d[i]^2 + u_smooth^2);
    by[i]*sqrt(tau^2 + (slew*d[i]/u_reference)^2)*der(y[i]) = d[i];
  end for;
  annotation (Documentation(info="<html>
<p>tau_coil c_dot = u(t - dead_time) - c, y_dot = d/sqrt(tau^2 + (slew d/0.35 A)^2), d = c - y, for either valve;
where d is negative, y_dot is divided by ratio. Far from the command the rate is limited to 0.35 A/slew, near to it
tau is a time constant. Source: data sheets of solenoid and proportional valves state dead time, rise time, fall time
and slew rate; the inductance of the coil comes before the plunger, whose greatest speed is that of its force against
the damping of the fluid. One lag, two, a limited rate (also one that is another downwards) and what rounds it are met
within 1 % of what they change in the readings, second-order lags with a damping ratio above 0.7 within 5 % of a
step; what overshoots is
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveSecondOrder\">ValveSecondOrder</a>. Typical 5 to 100 ms
each, ratio 0.5 to 2. Both valves are shut before the start.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveLag\">ValveLag</a> and
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveDelay\">ValveDelay</a>; opening is late by another time
than closing, or the later the larger the step.</p>
</html>"));
end FlexibleDrive;

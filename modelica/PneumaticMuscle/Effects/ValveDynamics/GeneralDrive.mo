within PneumaticMuscle.Effects.ValveDynamics;
model GeneralDrive
  "The valves follow by a dead time, lags, a limited rate, an oscillator, from a seat, each in its times"
  extends Interfaces.ValveDrive(y(each start=seat, each fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final general=true,
    final absent="tau=1e-6, slew=1e-6, ratio=1, tau_coil=1e-6, dead_time=1e-6, omega=1e3, zeta=0.3, seat=0, pair=1");
  parameter Types.Time tau(min=1e-6, max=2, nominal=0.05) = 0.03 "Time constant of opening"
    annotation (Dialog(group="Effect"));
  parameter Types.Time slew(min=1e-6, max=2, nominal=0.05) = 0.01
    "Time for 0.35 A at the maximum rate"
    annotation (Dialog(group="Effect"));
  parameter Real ratio(unit="1", min=0.05, max=20, nominal=1) = 1 "Both times of closing, by those of opening"
    annotation (Dialog(group="Effect"));
  parameter Real bend(unit="1", min=-2, max=2, nominal=0.3) = 0
    "Decrease of the logarithm of tau with the current, per 0.35 A beyond 0.35 A"
    annotation (Dialog(group="Effect"));
  parameter Real direct(unit="1", min=0, max=0.9, nominal=0.3) = 0.1 "Fraction without delay"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau_coil(min=1e-6, max=2, nominal=0.05) = 0.01 "Time constant of the coil"
    annotation (Dialog(group="Effect"));
  parameter Types.Time dead_time(min=1e-6, max=2, nominal=0.05) = 0.01 "Dead time" annotation (Dialog(group="Effect"));
  parameter Real omega(unit="rad/s", min=5, max=1e3, nominal=50) = 200
    "Undamped angular frequency of the moving part"
    annotation (Dialog(group="Effect"));
  parameter Real zeta(unit="1", min=0.3, max=2, nominal=1) = 1 "Its damping ratio" annotation (Dialog(group="Effect"));
  parameter Types.Current seat(min=0, max=0.145, nominal=0.05) = 0.02
    "Current at which the plunger leaves its seat"
    annotation (Dialog(group="Effect"));
  parameter Real pair(unit="1", min=0.05, max=20, nominal=1) = 1
    "All times of the exhaust valve, by those of the inlet valve"
    annotation (Dialog(group="Effect"));
  Types.Current c[2](each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial) "Currents of the coils";
  Types.Current z[2](each start=seat, each fixed=dynamics == Types.Dynamics.FixedInitial)
    "What follows them in its time";
  Real w[2](each unit="A/s", each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial, each nominal=1)
    "Rates of the currents that are felt";
protected
  parameter Types.Time t_0(fixed=false) "Start time";
  constant Types.Current u_reference = 0.35 "Current to which slew refers";
  constant Types.Current u_smooth = 5e-3 "Difference of currents over which opening and closing change roles";
  constant Types.Current e_smooth = 1e-6 "Current over which the seat is left, where it is left at once";
  Types.Current e[2] "Currents of the coils, not below that of the seat";
  final parameter Real late[2](each unit="1") = {1, pair} "Factors on all times";
  Types.Current d[2] "What the currents that follow still lack";
  Real by[2](each unit="1") "Factor on both times: 1 in opening, ratio in closing";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(c) = zeros(2);
    der(z) = zeros(2);
    der(y) = zeros(2);
    der(w) = zeros(2);
  end if;
  t_0 = time;
equation
  for i in 1:2 loop
    late[i]*tau_coil*der(c[i]) = (if dynamics == Types.Dynamics.SteadyStateInitial or
      time > t_0 + late[i]*dead_time then delay(u[i], late[i]*dead_time) else 0) - c[i];
    e[i] = 0.5*(c[i] + seat + sqrt((c[i] - seat)^2 + (0.03*seat)^2 + e_smooth^2));
    d[i] = e[i] - z[i];
    by[i] = late[i]*(0.5*(1 + ratio) + 0.5*(1 - ratio)*d[i]/sqrt(d[i]^2 + u_smooth^2));
    by[i]*sqrt((tau*exp(bend*(1 - z[i]/u_reference)))^2 + (slew*d[i]/u_reference)^2)*der(z[i]) = d[i];
    der(y[i]) = w[i];
    late[i]^2*der(w[i]) = omega^2*(direct*e[i] + (1 - direct)*z[i] - y[i]) - 2*zeta*omega*late[i]*w[i];
  end for;
  annotation (Documentation(info="<html>
<p>e = max(c, seat), c as in
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.FlexibleDrive\">FlexibleDrive</a>; z follows e as there, with
tau exp(bend (1 - z/0.35 A)), then y_ddot + 2 zeta omega y_dot + omega^2 y = omega^2 (direct e + (1 - direct) z) for
either valve; all times of the exhaust valve are pair times those of the inlet valve. Source: see
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.FlexibleDrive\">FlexibleDrive</a> and
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveSecondOrder\">ValveSecondOrder</a>, one behind the
other; the share that comes at once is what of the magnetic force iron, rubber or hysteresis does not hold back. A
preload holds the plunger on its seat until the current overcomes it: with a seat of 0.145 A, the threshold of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62), the opening itself lags
(<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.OpeningLag\">OpeningLag</a>,
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.OpeningRateLimit\">OpeningRateLimit</a>,
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.FlexibleOpening\">FlexibleOpening</a>), below it plunger or
spool have a dead travel, with 0 the current lags. Two valves of one make differ, and one of them may stick. Both valves
are shut before the start. Typical as there, direct 0 to 0.5, pair 0.5 to 2.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.FlexibleDrive\">FlexibleDrive</a> and
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.FlexibleOpening\">FlexibleOpening</a>; a quick beginning with
a long tail, or an overshoot.</p>
</html>"));
end GeneralDrive;

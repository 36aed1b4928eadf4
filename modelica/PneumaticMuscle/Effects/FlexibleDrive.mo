within PneumaticMuscle.Effects;
model FlexibleDrive "The valves open and close late, by a dead time and by lags that differ"
  extends Interfaces.ValveDrive(y(each start=0, each fixed=true));
  extends Interfaces.Effect(final family="valve_dynamics", final balance="mass",
    final absent="tau_open=1e-4, tau_close=1e-4, dead_time=1e-3");
  parameter Types.Time tau_open(min=1e-4, max=2, nominal=0.05) = 0.05 "Time constant while the current that is felt rises";
  parameter Types.Time tau_close(min=1e-4, max=2, nominal=0.05) = 0.03 "Time constant while it falls";
  parameter Types.Time dead_time(min=1e-3, max=2, nominal=0.05) = 0.02 "Dead time";
protected
  constant Types.Current u_smooth = 5e-3 "Difference of currents over which the lags change roles";
  Types.Current d[2] "What the currents that are felt still lack";
equation
  for i in 1:2 loop
    d[i] = delay(if initial() then 0 else u[i], dead_time) - y[i];
    (0.5*(tau_open + tau_close) + 0.5*(tau_open - tau_close)*d[i]/sqrt(d[i]^2 + u_smooth^2))*der(y[i]) = d[i];
  end for;
  annotation (Documentation(info="<html>
<p>tau y_dot = u(t - dead_time) - y, with tau_open where the right side is positive and tau_close where it is negative,
for either valve. Source: data sheets of solenoid and proportional valves state dead time, rise time and fall time;
first-order lag with dead time is the usual reduction of any sluggish chain (J. G. Ziegler and N. B. Nichols, 1942). A
second-order lag with a damping ratio above 0.7 is met within 4 % of a step, a slew rate within 9 %. Typical 5 to 100
ms each. Both valves are shut before the start.</p>
<p>Fingerprint: as ValveLag and ValveDelay; opening is late by another time than closing.</p>
</html>"));
end FlexibleDrive;

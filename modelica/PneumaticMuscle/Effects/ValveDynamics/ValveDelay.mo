within PneumaticMuscle.Effects.ValveDynamics;
model ValveDelay "The valves open and close late"
  extends Interfaces.ValveDrive;
  extends FamilyMember(final absent="dead_time=1e-6");
  parameter Types.Time dead_time(min=1e-6, max=2, nominal=0.05) = 0.05 "Dead time" annotation (Dialog(group="Effect"));
protected
  parameter Types.Time t_0(fixed=false) "Start time";
initial equation
  t_0 = time;
equation
  for i in 1:2 loop
    y[i] = if dynamics == Types.Dynamics.SteadyStateInitial or time > t_0 + dead_time then
       delay(u[i], dead_time) else 0;
  end for;
  annotation (Documentation(info="<html>
<p>y(t) = u(t - dead_time) for either valve, exactly. Source: the dead time of a solenoid until its plunger moves, and
of the electronics before it. Typical 5 to 100 ms. Both valves are shut before the start.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveLag\">ValveLag</a>, but after every
switching nothing at all happens for the dead time, and then everything at once.</p>
</html>"));
end ValveDelay;

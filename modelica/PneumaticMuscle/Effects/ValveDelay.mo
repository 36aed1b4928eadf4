within PneumaticMuscle.Effects;
model ValveDelay "The valves open and close late"
  extends Interfaces.ValveDrive;
  extends Interfaces.Effect(final family="valve_dynamics", final balance="mass", final absent="delay=1e-3");
  parameter Types.Time delay(min=1e-3, max=2, nominal=0.05) = 0.05 "Dead time";
equation
  for i in 1:2 loop
    y[i] = delay(if initial() then 0 else u[i], delay);
  end for;
  annotation (Documentation(info="<html>
<p>y(t) = u(t - delay) for either valve, exactly. Source: the dead time of a solenoid until its plunger moves, and
of the electronics before it. Typical 5 to 100 ms. Both valves are shut before the start.</p>
<p>Fingerprint: as ValveLag, but after every switching nothing at all happens for the dead time, and then everything
at once.</p>
</html>"));
end ValveDelay;

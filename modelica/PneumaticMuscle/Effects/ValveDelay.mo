within PneumaticMuscle.Effects;
model ValveDelay "The valves open and close late"
  extends Interfaces.ValveDrive;
  extends Interfaces.Effect(final family="valve_dynamics", final balance="mass", final absent="delay=1e-3");
  parameter Types.Time delay(min=1e-3, max=2, nominal=0.05) = 0.05 "Dead time";
protected
  constant Integer stages = 8 "Number of lags in the chain";
  Types.Current c1[stages](each start=0, each fixed=true) "Chain of the inlet valve";
  Types.Current c2[stages](each start=0, each fixed=true) "Chain of the exhaust valve";
equation
  delay/stages*der(c1[1]) = u[1] - c1[1];
  delay/stages*der(c2[1]) = u[2] - c2[1];
  for i in 2:stages loop
    delay/stages*der(c1[i]) = c1[i - 1] - c1[i];
    delay/stages*der(c2[i]) = c2[i - 1] - c2[i];
  end for;
  y[1] = c1[stages];
  y[2] = c2[stages];
  annotation (Documentation(info="<html>
<p>A dead time as a chain of eight equal lags: a step comes out at the dead time, spread by a third of it.
Source: the dead time of a solenoid until its plunger moves, typical 5 to 50 ms; lag chains: method of stages.
Both valves are shut before the start.</p>
<p>Fingerprint: as ValveLag, with nothing at all happening at first.</p>
</html>"));
end ValveDelay;

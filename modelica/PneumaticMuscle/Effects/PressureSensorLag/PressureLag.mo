within PneumaticMuscle.Effects.PressureSensorLag;
model PressureLag "The pressure reading lags"
  extends Interfaces.PressureChannel;
  extends FamilyMember(final absent="tau=1e-6");
  parameter Types.Time tau(min=1e-6, max=5, nominal=0.05) = 0.05 "Time constant"
    annotation (Dialog(group="Effect"));
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    y = u;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(y) = 0;
  end if;
equation
  tau*der(y) = u - y;
  annotation (Documentation(info="<html>
<p>tau y_dot = u - y, from y = u at the start. Source: the filter of a measuring amplifier, and the gas in front of the
diaphragm behind a snubber or a thin tube, whose resistance by its capacity is tau. Typical 1 to 200 ms.</p>
<p>Fingerprint: the pressure is late while it changes and soft at every switching; contraction and temperature are
right.</p>
</html>"));
end PressureLag;

within PneumaticMuscle.Effects.PressureSensorLag;
model PressureDelay "The pressure reading comes late by a dead time"
  extends Interfaces.PressureChannel;
  extends FamilyMember(final absent="dead_time=1e-6");
  parameter Types.Time dead_time(min=1e-6, max=1, nominal=0.05) = 0.03 "Dead time"
    annotation (Dialog(group="Effect"));
  Types.GaugePressure z "What the second-order lag in it gives";
  Real w(unit="Pa/s", nominal=1e6) "Its rate";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    z = u;
    w = 0;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(z) = 0;
    der(w) = 0;
  end if;
equation
  der(z) = w;
  dead_time^2*der(w) = 12*(u - z) - 6*dead_time*w;
  y = u - dead_time*w;
  annotation (Documentation(info="<html>
<p>y(t) = u(t - dead_time) in the approximation of Pade of second order, y = (1 - T s/2 + T^2 s^2/12)/(1 + T s/2 + T^2
s^2/12) u: right in phase and size up to about 2/dead_time rad/s. Where a ramp begins it is wrong by less than a
tenth of the ramp times dead_time, for about as long. Source: a fieldbus, a slow converter, a digital filter of many
taps; the speed of sound in a long tube (3 ms per metre). Typical 1 to 100 ms.</p>
<p>Fingerprint: the pressure is late by the same time everywhere, sharp at every switching; contraction and temperature
are right.</p>
</html>"));
end PressureDelay;

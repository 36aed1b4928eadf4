within PneumaticMuscle.Effects.PressureSensorLag;
model GeneralPressureLag "The pressure reading comes late by two lags, a dead time, and otherwise when it falls"
  extends Interfaces.PressureChannel;
  extends FamilyMember(final general=true, final absent="tau=1e-6, ratio=1, r=1e-3, dead_time=1e-6");
  parameter Types.Time tau(min=1e-6, max=5, nominal=0.05) = 0.03 "Greater time constant"
    annotation (Dialog(group="Effect"));
  parameter Real ratio(unit="1", min=0.2, max=5, nominal=1) = 1
    "Ratio of the time constants of falling and rising readings"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=1e-3, max=1, nominal=0.3) = 0.1 "Second time constant by the first"
    annotation (Dialog(group="Effect"));
  parameter Types.Time dead_time(min=1e-6, max=1, nominal=0.05) = 0.01 "Dead time"
    annotation (Dialog(group="Effect"));
  Types.GaugePressure z "Pressure behind the first lag";
  Types.GaugePressure z_2 "Pressure behind the second";
  Types.GaugePressure z_3 "What the second-order lag of the dead time gives";
  Real w(unit="Pa/s", nominal=1e6) "Its rate";
protected
  constant Types.GaugePressure d_smooth = 100 "Difference over which rising and falling change roles";
  Types.GaugePressure d "What the first lag still lacks";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    z = u;
    z_2 = u;
    z_3 = u;
    w = 0;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(z) = 0;
    der(z_2) = 0;
    der(z_3) = 0;
    der(w) = 0;
  end if;
equation
  d = u - z;
  (0.5*(1 + ratio) + 0.5*(1 - ratio)*d/sqrt(d^2 + d_smooth^2))*tau*der(z) = d;
  r*tau*der(z_2) = z - z_2;
  der(z_3) = w;
  dead_time^2*der(w) = 12*(z_2 - z_3) - 6*dead_time*w;
  y = z_2 - dead_time*w;
  annotation (Documentation(info="<html>
<p>tau z_dot = u - z, with ratio tau where the pressure falls; r tau z_2_dot = z - z_2; then the dead time of
<a href=\"modelica://PneumaticMuscle.Effects.PressureSensorLag.PressureDelay\">PressureDelay</a>. Source: those of the
family in one; a snubber with a check ball, or whose resistance depends on the density, is slower one way. Typical as
there.</p>
<p>Fingerprint: as those.</p>
</html>"));
end GeneralPressureLag;

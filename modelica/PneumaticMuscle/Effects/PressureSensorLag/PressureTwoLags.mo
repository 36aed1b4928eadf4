within PneumaticMuscle.Effects.PressureSensorLag;
model PressureTwoLags "The pressure reading lags twice"
  extends Interfaces.PressureChannel;
  extends FamilyMember(final absent="tau=1e-6, r=1e-3");
  parameter Types.Time tau(min=1e-6, max=5, nominal=0.05) = 0.05 "Greater time constant"
    annotation (Dialog(group="Effect"), __PamCosim(at_min=""));
  parameter Real r(unit="1", min=1e-3, max=1, nominal=0.3) = 0.3 "Second time constant by the first"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="PressureLag"));
  Types.GaugePressure z "Pressure behind the first lag";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    z = u;
    y = u;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(z) = 0;
    der(y) = 0;
  end if;
equation
  tau*der(z) = u - z;
  r*tau*der(y) = z - y;
  annotation (Documentation(info="<html>
<p>tau z_dot = u - z, r tau y_dot = z - y. Source: a snubber in front of the diaphragm and a filter behind it. Typical 1
to 200 ms, 0.05 to 1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.PressureSensorLag.PressureLag\">PressureLag</a>, with a
soft beginning.</p>
</html>"));
end PressureTwoLags;

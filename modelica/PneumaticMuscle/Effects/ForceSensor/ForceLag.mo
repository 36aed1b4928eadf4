within PneumaticMuscle.Effects.ForceSensor;
model ForceLag "The force reading lags"
  extends Interfaces.ForceChannel;
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
<p>tau y_dot = u - y, from y = u at the start. Source: the low-pass filter of a measuring amplifier, 1/(2 pi f_c) by its
corner frequency; typical 1 to 200 ms.</p>
<p>Fingerprint: the force is late in motion and right at rest; pressure and temperature are not late.</p>
</html>"));
end ForceLag;

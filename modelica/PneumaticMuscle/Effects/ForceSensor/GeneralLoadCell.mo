within PneumaticMuscle.Effects.ForceSensor;
model GeneralLoadCell "The force reading is any smooth function of the force, late by two time constants"
  extends Interfaces.ForceChannel;
  extends FamilyMember(final general=true, final absent="offset=0, gain=1, bend=0, c=0, tau=1e-6, r=1e-3");
  parameter Real offset(unit="N", min=-500, max=500, nominal=2) = 2 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-10, 10}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.03 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.5, max=0.5, nominal=0.03) = 0.01 "Coefficient of the second power, by 100 N"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.02, 0.02}));
  parameter Real c(unit="1", min=-0.3, max=0.3, nominal=0.03) = 0 "Coefficient of the third power, by 100 N squared"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.013, 0.013}));
  parameter Types.Time tau(min=1e-6, max=5, nominal=0.05) = 0.02 "Time constant"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=1e-3, max=1, nominal=0.1) = 0.1 "Second time constant by the first"
    annotation (Dialog(group="Effect"));
  Types.Force z "What follows the transducer";
protected
  constant Types.Force reference = 100 "What the coefficients refer to";
  Real w(unit="1") "Signal by the reference";
  Types.Force shown "What the reading would be without lag";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    z = shown;
    y = shown;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(z) = 0;
    der(y) = 0;
  end if;
equation
  w = u/reference;
  shown = offset + reference*w*(gain + w*(bend + c*w));
  tau*der(z) = shown - z;
  r*tau*der(y) = z - y;
  annotation (Documentation(info="<html>
<p>Y = offset + 100 N (gain w + bend w^2 + c w^3), w = u/100 N, tau z_dot = Y - z, r tau y_dot = z - y. Source:
<a href=\"modelica://PneumaticMuscle.Effects.ForceSensor.FlexibleLoadCell\">FlexibleLoadCell</a> and
<a href=\"modelica://PneumaticMuscle.Effects.ForceSensor.ForceLag\">ForceLag</a> in one, see there, with a third power
and a second pole of the filter. Typical as there, each power 0.5 % of 100 N at
most.</p>
<p>Fingerprint: as those.</p>
</html>"));
end GeneralLoadCell;

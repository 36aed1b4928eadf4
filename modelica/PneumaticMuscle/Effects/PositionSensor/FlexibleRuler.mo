within PneumaticMuscle.Effects.PositionSensor;
model FlexibleRuler "The position reading has errors of zero, span and linearity"
  extends Interfaces.PositionChannel;
  extends FamilyMember(final absent="offset=0, gain=1, bend=0");
  parameter Real offset(unit="m", min=-0.1, max=0.1, nominal=1e-3) = 1e-3 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-5e-3, 5e-3}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.03 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.3, max=0.3, nominal=0.03) = 0.01
    "Quadratic coefficient of the reading, per 50 mm"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.02, 0.02}));
protected
  constant Types.Length reference = 0.05 "What bend refers to";
equation
  y = offset + u*(gain + bend*u/reference);
  annotation (Documentation(info="<html>
<p>y = offset + gain d + bend d^2/(50 mm), d = u. Source: zero, span and linearity error, the three lines of a
transducer's data sheet (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.1 to 5
mm, 0.1 to 5 %, 0.1 to 1 % of a full scale of 100 mm.</p>
<p>Fingerprint: the position is off by a smooth curve of itself, at rest too; pressure and temperature are right.</p>
</html>"));
end FlexibleRuler;

within PneumaticMuscle.Effects.ForceSensor;
model FlexibleLoadCell "The force reading has errors of zero, span and linearity"
  extends Interfaces.ForceChannel;
  extends FamilyMember(final absent="offset=0, gain=1, bend=0");
  parameter Real offset(unit="N", min=-500, max=500, nominal=2) = 2 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-10, 10}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.03 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.3, max=0.3, nominal=0.03) = 0.01
    "Quadratic coefficient of the reading, per 100 N"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.02, 0.02}));
protected
  constant Types.Force reference = 100 "What bend refers to";
equation
  y = offset + u*(gain + bend*u/reference);
  annotation (Documentation(info="<html>
<p>y = offset + gain d + bend d^2/(100 N), d = u. Source: zero, span and linearity error, the three lines of a
transducer's data sheet (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.02 to
1 % of full scale, 0.02 to 5 %, 0.02 to 0.5 %: of a full scale of 1 kN the first, of 100 N the last, whose bend is
greatest.</p>
<p>Fingerprint: the force is off by a smooth curve of itself, at rest too; pressure and temperature are right.</p>
</html>"));
end FlexibleLoadCell;

within PneumaticMuscle.Effects.PressureOffset;
model FlexibleGauge "The pressure reading has errors of zero, span and linearity"
  extends Interfaces.Manometer;
  extends FamilyMember(final absent="offset=0, gain=1, bend=0");
  parameter Types.GaugePressure offset(min=-1.5e5, max=1.5e5, nominal=1e3) = 1e3
    "Offset of the reading at ambient pressure"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-2e4, 2e4}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.01 "Slope of the reading at ambient pressure"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.1, max=0.1, nominal=0.03) = 0.01
    "Quadratic coefficient of the reading, per 100 kPa"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.016, 0.016}));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure to which bend refers";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
equation
  p = offset + p_gauge*(gain + bend*p_gauge/p_reference);
  annotation (Documentation(info="<html>
<p>p = offset + gain p_gauge + bend p_gauge^2/100 kPa. Source: zero, span and linearity error, the three lines of a
transducer's data sheet; typical 0.1 to 2 % of full scale, 0.1 to 5 %, 0.1 to 1 %: of full scales of
1 MPa the first, of 250 kPa the last, whose bend is greatest. Dial gauges are within 0.1 to 4 % of their range, by
accuracy class (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">EN 837-1</a>).</p>
<p>Fingerprint: the pressure is off by a smooth curve of itself, before the start too; contraction and temperature
are right.</p>
</html>"));
end FlexibleGauge;

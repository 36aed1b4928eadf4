within PneumaticMuscle.Effects.PressureOffset;
model PressureOffset "The pressure reading is off by a constant"
  extends Interfaces.Manometer;
  extends FamilyMember(final absent="offset=0");
  parameter Types.GaugePressure offset(min=-1.5e5, max=1.5e5, nominal=1e3) = 3e3 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-2e4, 2e4}));
equation
  p = port.p - ambient.p + offset;
  annotation (Documentation(info="<html>
<p>p = p_gauge + offset. Source: zero error, the first line of a transducer's data sheet; typical 0.1 to 2 % of
full scale, and full scale 1 MPa: 20 kPa at most. Dial gauges are within 0.1 to 4 % of their range, by accuracy class
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">EN 837-1</a>). The bounds hold an absolute pressure
that was recorded as a gauge pressure, or the other way round: 101 kPa.</p>
<p>Fingerprint: the pressure is off by the same amount everywhere, before the start too; contraction and
temperature are right.</p>
</html>"));
end PressureOffset;

within PneumaticMuscle.Effects.PressureOffset;
model GeneralGauge "The pressure reading is any smooth function of the pressure, with a knee and a jump"
  extends Interfaces.Manometer;
  extends FamilyMember(final general=true,
    final absent="offset=0, gain=1, bend=0, c=0, d=0, knee=0, jump=0");
  parameter Types.GaugePressure offset(min=-1.5e5, max=1.5e5, nominal=1e3) = 1e3
    "Offset of the reading at ambient pressure"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-2e4, 2e4}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.01 "Slope of the reading at ambient pressure"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.5, max=0.5, nominal=0.03) = 0.01 "Coefficient of the second power, per 100 kPa"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.016, 0.016}));
  parameter Real c(unit="1", min=-0.3, max=0.3, nominal=0.03) = 0 "Coefficient of the third power, per 100 kPa squared"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.0042, 0.0042}));
  parameter Real d(unit="1", min=-0.1, max=0.1, nominal=0.01) = 0 "Coefficient of the fourth power, per 100 kPa cubed"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.00135, 0.00135}));
  parameter Real knee(unit="1", min=-1, max=1, nominal=0.03) = 0 "Change of slope at the knee"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.2, 0.2}));
  parameter Types.Pressure jump(min=-2e4, max=2e4, nominal=1e3) = 0 "Jump of the reading at the knee"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-5e3, 5e3}));
  parameter Types.GaugePressure p_knee(min=0, max=1e6, nominal=1e5) = 8e4 "Pressure of the knee"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure width(min=1e3, max=2e5, nominal=1e4) = 1e4 "Half width of the rounding"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure to which the coefficients refer";
  Real q(unit="1") = (port.p - ambient.p)/p_reference "Gauge pressure by the reference";
  Types.GaugePressure beyond = port.p - ambient.p - p_knee "Pressure beyond that of the knee";
equation
  p = offset + p_reference*q*(gain + q*(bend + q*(c + d*q))) + 0.5*knee*(beyond + sqrt(beyond^2 + width^2))
    + 0.5*jump*(1 + beyond/sqrt(beyond^2 + width^2));
  annotation (Documentation(info="<html>
<p>p = offset + 100 kPa (gain q + bend q^2 + c q^3 + d q^4) + knee/2 (b + sqrt(b^2 + width^2)) + jump/2 (1 +
b/sqrt(b^2 + width^2)), q = p_gauge/100 kPa, b = p_gauge - p_knee. Source: zero, span and linearity error of a
transducer's data sheet, the last as a polynomial; a pointer leaves its stop pin at a pressure (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">EN 837-1</a>), a transmitter's table of points has a knee at
each, and a manometer that changes its range jumps there, as each range has an adjustment of its own, of 1 or 2 % of
its end. Typical as <a href=\"modelica://PneumaticMuscle.Effects.PressureOffset.FlexibleGauge\">FlexibleGauge</a>,
each power 1 % of 250 kPa at most.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.PressureOffset.FlexibleGauge\">FlexibleGauge</a>.</p>
</html>"));
end GeneralGauge;

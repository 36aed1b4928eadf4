within PneumaticMuscle.Effects.PressureOffset;
model PressureGain "The pressure reading is off by a factor"
  extends Interfaces.Manometer;
  extends FamilyMember(final absent="gain=1");
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.03 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
equation
  p = gain*(port.p - ambient.p);
  annotation (Documentation(info="<html>
<p>p = gain p_gauge. Source: span error, the second line of a transducer's data sheet; typical 0.1 to 5 %.
Dial gauges are within 0.1 to 4 % of their range, by accuracy class
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">EN 837-1</a>).</p>
<p>Fingerprint: the pressure is off in proportion to itself and settles beside the supply's; contraction and
temperature are right.</p>
</html>"));
end PressureGain;

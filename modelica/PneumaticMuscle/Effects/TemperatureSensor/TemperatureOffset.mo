within PneumaticMuscle.Effects.TemperatureSensor;
model TemperatureOffset "The temperature reading is off by a constant"
  extends Interfaces.TemperatureChannel;
  extends FamilyMember(final absent="offset=0");
  parameter Real offset(unit="K", min=-50, max=50, nominal=1) = 1 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-2.5, 2.5}));
equation
  y = u + offset;
  annotation (Documentation(info="<html>
<p>y = u + offset. Source: zero error, the first line of a transducer's data sheet
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.5 to 2.5 K (class 1 and 2 of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 60584</a>-1), and what the reference junction is
off: some 25 K where nothing compensates for it.</p>
<p>Fingerprint: the temperature is off by the same amount everywhere, at rest before the start too; pressure and
contraction are right.</p>
</html>"));
end TemperatureOffset;

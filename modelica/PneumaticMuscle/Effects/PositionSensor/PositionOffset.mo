within PneumaticMuscle.Effects.PositionSensor;
model PositionOffset "The position reading is off by a constant"
  extends Interfaces.PositionChannel;
  extends FamilyMember(final absent="offset=0");
  parameter Real offset(unit="m", min=-0.1, max=0.1, nominal=1e-3) = 1e-3 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-5e-3, 5e-3}));
equation
  y = u + offset;
  annotation (Documentation(info="<html>
<p>y = u + offset. Source: zero error, the first line of a transducer's data sheet
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.1 to 5 mm, where the muscle
was mounted or the string of a transducer hooked in; any part of the stroke where its zero was never set.</p>
<p>Fingerprint: the position is off by the same amount everywhere, at rest before the start too; pressure and
temperature are right.</p>
</html>"));
end PositionOffset;

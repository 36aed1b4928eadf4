within PneumaticMuscle.Effects.ForceSensor;
model ForceOffset "The force reading is off by a constant"
  extends Interfaces.ForceChannel;
  extends FamilyMember(final absent="offset=0");
  parameter Real offset(unit="N", min=-500, max=500, nominal=2) = 2 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-10, 10}));
equation
  y = u + offset;
  annotation (Documentation(info="<html>
<p>y = u + offset. Source: zero error, the first line of a transducer's data sheet
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.02 to 1 % of full scale, and
full scale 1 kN: 10 N at most; more, as what hangs on it weighs, where the load cell was not tared.</p>
<p>Fingerprint: the force is off by the same amount everywhere, at rest before the start too; pressure and temperature
are right.</p>
</html>"));
end ForceOffset;

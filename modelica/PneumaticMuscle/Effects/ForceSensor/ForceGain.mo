within PneumaticMuscle.Effects.ForceSensor;
model ForceGain "The force reading is off by a factor"
  extends Interfaces.ForceChannel;
  extends FamilyMember(final absent="gain=1");
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.03 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
equation
  y = gain*u;
  annotation (Documentation(info="<html>
<p>y = gain u. Source: span error, the second line of a transducer's data sheet
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.02 to 5 %.</p>
<p>Fingerprint: the force is off in proportion to itself; pressure and temperature are right.</p>
</html>"));
end ForceGain;

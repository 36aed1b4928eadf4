within PneumaticMuscle.Effects.TemperatureSensor;
model TemperatureGain "The temperature reading is off by a factor"
  extends Interfaces.TemperatureChannel;
  extends FamilyMember(final absent="gain=1");
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.05 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
protected
  outer Ambient ambient "Surroundings";
equation
  y = ambient.T + gain*(u - ambient.T);
  annotation (Documentation(info="<html>
<p>y = T_atm + gain (u - T_atm). Source: span error, the second line of a transducer's data sheet
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2); typical 0.4 to 5 %; more where a stem
carries heat to the surroundings.</p>
<p>Fingerprint: the temperature is off in proportion to its difference from ambient; pressure and contraction are
right.</p>
</html>"));
end TemperatureGain;

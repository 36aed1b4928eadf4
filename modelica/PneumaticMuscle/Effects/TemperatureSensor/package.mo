within PneumaticMuscle.Effects;
package TemperatureSensor "A thermometer that is out of true"
  extends Icons.TemperatureSensor;
  annotation (Documentation(info="<html>
<p>The family <code>temperature_sensor</code>: the record of a temperature against what the thermometer has.</p>
<p>Fingerprint: the temperature alone is off, at rest before the start too where the zero is wrong; pressure and
contraction are right. What is late belongs to thermocouple_lag.</p>
</html>"));
end TemperatureSensor;

within PneumaticMuscle.Effects;
package ThermocoupleLag "A thermometer that follows late"
  extends Icons.ThermocoupleLag;
  annotation (Documentation(info="<html>
<p>The family <code>thermocouple_lag</code>: the reading of the thermometer against the temperature of the gas.</p>
<p>Fingerprint: the temperature is smooth and late; pressure and contraction are right. Members differ in how the
reading begins and ends.</p>
</html>"));
end ThermocoupleLag;

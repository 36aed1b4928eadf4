within PneumaticMuscle.Effects;
package PressureSensorLag "A pressure transducer that follows late"
  extends Icons.PressureSensorLag;
  annotation (Documentation(info="<html>
<p>The family <code>pressure_sensor_lag</code>: the record of a pressure comes later than the pressure.</p>
<p>Fingerprint: the pressure alone is late while it changes, and right in the holds; contraction, force and temperature
are neither late nor off.</p>
</html>"));
end PressureSensorLag;

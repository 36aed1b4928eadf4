within PneumaticMuscle.Effects;
package ForceSensor "A load cell that is out of true, or late"
  extends Icons.ForceSensor;
  annotation (Documentation(info="<html>
<p>The family <code>force_sensor</code>: the record of a force against the force.</p>
<p>Fingerprint: the force alone is off, without load too where the zero is wrong, at changes only where it is late;
pressure, position and temperature are right.</p>
</html>"));
end ForceSensor;

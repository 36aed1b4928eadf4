within PneumaticMuscle.Effects;
package PositionSensor "A displacement transducer that is out of true, or late"
  extends Icons.PositionSensor;
  annotation (Documentation(info="<html>
<p>The family <code>position_sensor</code>: the record of a position against the position.</p>
<p>Fingerprint: the position alone is off, at rest on the stop too where the zero is wrong, in motion only where it is
late; pressure, force and temperature are right.</p>
</html>"));
end PositionSensor;

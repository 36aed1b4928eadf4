within PneumaticMuscle.Effects;
package ClockOffset "Readings whose record is not in time with that of the inputs"
  extends Icons.ClockOffset;
  annotation (Documentation(info="<html>
<p>The family <code>clock_offset</code>: inputs and readings are recorded by two loggers, of which one runs early.</p>
<p>Fingerprint: all readings are late, or early, by the same time in all runs, against all inputs; early ones begin in
motion. Against each other they are in time.</p>
</html>"));
end ClockOffset;

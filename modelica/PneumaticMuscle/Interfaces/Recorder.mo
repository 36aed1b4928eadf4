within PneumaticMuscle.Interfaces;
partial model Recorder "What the clock of the record shows"
  extends Icons.Recorder;
  Types.Time t "Time of the record";
  annotation (Documentation(info="<html>
<p>What the instruments show at <code>time</code>, the time of the inputs, is recorded for t. Left to the extending
class: the equation of t.</p>
<p>A model cannot show its future, so a clock changes nothing in the equations of a bench. Who holds a bench against a
record reads its outputs when t is the time of the record. A parameter of
<a href=\"modelica://PneumaticMuscle.Types.RecordDelay\">Types.RecordDelay</a> says by how much t is ahead of time; this
project's simulator reads all outputs that much earlier, or later, than it is asked for. Another tool's outputs are to
be drawn over t.</p>
</html>"));
end Recorder;

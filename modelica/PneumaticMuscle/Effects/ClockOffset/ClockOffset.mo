within PneumaticMuscle.Effects.ClockOffset;
model ClockOffset "All readings are recorded late or early"
  extends Interfaces.Recorder;
  extends FamilyMember(final absent="shift=0");
  parameter Types.RecordDelay shift(min=-2, max=2) = 0.02 "Delay of the recorded readings; negative: early"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.5, 0.5}));
equation
  t = time + shift;
  annotation (Documentation(info="<html>
<p>t = time + shift, the same in all runs. Source: two loggers that were started one after the other, or one that stamps
a block of samples when it ends. Typical -0.5 to 0.5 s. What a record shows before the start is what the model has at
the start. Other tools draw outputs over <code>t</code>, see
<a href=\"modelica://PneumaticMuscle.Interfaces.Recorder\">Interfaces.Recorder</a>.</p>
<p>Fingerprint: every switching of a valve shows late, or early, in all readings alike. Where only the currents of the
valves change in a run, readings that are late cannot be told from valves with a dead time
(<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveDelay\">ValveDelay</a>); a step of the supply, or an
imposed motion, tells.</p>
</html>"));
end ClockOffset;

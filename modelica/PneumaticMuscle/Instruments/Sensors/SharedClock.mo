within PneumaticMuscle.Instruments.Sensors;
model SharedClock "One clock for inputs and readings"
  extends Interfaces.Recorder;
equation
  t = time;
  annotation (Documentation(info="<html>
<p>t = time.</p>
</html>"));
end SharedClock;

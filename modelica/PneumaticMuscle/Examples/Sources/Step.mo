within PneumaticMuscle.Examples.Sources;
block Step "A step with a short rise"
  extends Icons.Signal;
  parameter Real before = 0 "Value before the step" annotation (Dialog(group="Signal"));
  parameter Real after = 1 "Value after the step" annotation (Dialog(group="Signal"));
  parameter Types.Time start = 1 "Time in the middle of the rise" annotation (Dialog(group="Signal"));
  parameter Types.Time rise(min=1e-4) = 5e-3 "Time over which it rises" annotation (Dialog(group="Signal"));
  Interfaces.Signals.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  y = before + (after - before)*0.5*(1 + tanh((time - start)/rise));
  annotation (Documentation(info="<html>
<p>y = before + (after - before) (1 + tanh((t - start)/rise))/2.</p>
</html>"));
end Step;

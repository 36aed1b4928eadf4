within PneumaticMuscle.Examples.Sources;
block Pulse "One pulse with a short rise and fall"
  extends Icons.Signal;
  parameter Real rest = 0 "Value outside the pulse" annotation (Dialog(group="Signal"));
  parameter Real height = 0.35 "Value inside the pulse" annotation (Dialog(group="Signal"));
  parameter Types.Time start = 0 "Time in the middle of the rise" annotation (Dialog(group="Signal"));
  parameter Types.Time stop = 5 "Time in the middle of the fall" annotation (Dialog(group="Signal"));
  parameter Types.Time rise(min=1e-4) = 5e-3 "Time over which it rises and falls" annotation (Dialog(group="Signal"));
  Interfaces.Signals.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  y = rest + (height - rest)*0.5*(tanh((time - start)/rise) - tanh((time - stop)/rise));
  annotation (Documentation(info="<html>
<p>Two steps, see <a href=\"modelica://PneumaticMuscle.Examples.Sources.Step\">Step</a>. A start well before zero makes
a pulse that is on from the beginning.</p>
</html>"));
end Pulse;

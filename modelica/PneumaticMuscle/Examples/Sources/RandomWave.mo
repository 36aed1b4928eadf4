within PneumaticMuscle.Examples.Sources;
block RandomWave "A wave of random look: a sum of sines with fixed phases, up to a highest frequency"
  extends Icons.Signal;
  parameter Real frequency(unit="Hz", min=0.01, max=100) = 1 "Highest frequency" annotation (Dialog(group="Signal"));
  parameter Real low = 0 "Least value that the wave can take" annotation (Dialog(group="Signal"));
  parameter Real high = 1 "Largest value that the wave can take" annotation (Dialog(group="Signal"));
  Interfaces.Signals.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
protected
  constant Real part[6](each unit="1") = {0.173, 0.294, 0.427, 0.581, 0.769, 1} "Frequencies by the highest one";
  constant Real weight[6](each unit="1") = {0.8, 1, 0.9, 0.7, 0.8, 1} "Amplitudes";
  constant Real phase[6](each unit="rad") = {1.7989, 1.4636, 0.0987, 4.6282, 3.7445, 2.7889} "Phases, drawn once";
equation
  y = (low + high)/2
    + (high - low)/2*sum(weight[i]*sin(2*Constants.pi*part[i]*frequency*time + phase[i]) for i in 1:6)/5.2;
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 2 drive the muscle with a random wave of
pressure whose frequency they vary from 0.5 to 2 Hz; the signal is not given. This one is the same in every run, has no
short period, and reverses at many levels, so that there are small loops inside the large one.</p>
</html>"));
end RandomWave;

within PneumaticMuscle.Interfaces;
partial model Rig "What stands around a bench: the surroundings and the recorder"
  extends Icons.Bench;
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-170,70},{-130,110}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-110,70},{-70,110}})));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{160,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>A bench extends it: those of <a href=\"modelica://PneumaticMuscle.Benches\">Benches</a>, and one that is put together
from <a href=\"modelica://PneumaticMuscle.Pneumatics\">Pneumatics</a>,
<a href=\"modelica://PneumaticMuscle.Muscles\">Muscles</a>,
<a href=\"modelica://PneumaticMuscle.Mechanics\">Mechanics</a> and
<a href=\"modelica://PneumaticMuscle.Instruments\">Instruments</a>.</p>
</html>"));
end Rig;

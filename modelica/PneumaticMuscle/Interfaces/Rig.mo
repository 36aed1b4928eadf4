within PneumaticMuscle.Interfaces;
partial model Rig "What stands around the parts of a rig: the surroundings and the recorder"
  extends Icons.Bench;
  replaceable model Recorder = Sensors.SharedClock constrainedby Interfaces.Recorder "Recorder of the readings"
    annotation (choicesAllMatching=true);
  inner Components.Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-170,70},{-130,110}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-110,70},{-70,110}})));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{160,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>A bench that is put together from <code>Pneumatics</code>, <code>Muscles</code>, <code>Mechanics</code> and
<code>Instruments</code> extends it.</p>
</html>"));
end Rig;

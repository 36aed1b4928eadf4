within PneumaticMuscle.Benches.BaseClasses;
partial model ForceReading "A load cell below the muscle and its measuring channel"
  extends Icons.Named;
  Interfaces.Signals.ForceOutput F "Pull of the muscle"
    annotation (Placement(transformation(extent={{220,-75},{240,-55}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  replaceable model ForceChannel = Instruments.Sensors.DirectForce constrainedby Interfaces.ForceChannel
    "Measuring channel of the force"
    annotation (choicesAllMatching=true);
  Instruments.Sensors.Pull loadCell "Load cell"
    annotation (Placement(transformation(extent={{30,-85},{70,-45}})));
  ForceChannel channel_F "Measuring channel of the force"
    annotation (Placement(transformation(extent={{160,-85},{200,-45}})));
equation
  connect(loadCell.F, channel_F.u)
    annotation (Line(points={{70,-65}, {160,-65}}, color={0,0,127}));
  connect(channel_F.y, F)
    annotation (Line(points={{200,-65}, {230,-65}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p>Left to the extending class: what pulls at <code>loadCell.flange_a</code> and what holds <code>flange_b</code>, and
<code>channel_F.dynamics</code>, as for
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses.PressureReading\">PressureReading</a>.</p>
</html>"));
end ForceReading;

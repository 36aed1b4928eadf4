within PneumaticMuscle.Benches.BaseClasses;
partial model PositionReading "A displacement transducer at the load end and its measuring channel"
  extends Icons.Named;
  Interfaces.Signals.LengthOutput x "Contraction"
    annotation (Placement(transformation(extent={{220,-95},{240,-75}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  replaceable model PositionChannel = Instruments.Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
    annotation (choicesAllMatching=true);
  Instruments.Sensors.Contraction ruler "Displacement transducer"
    annotation (Placement(transformation(extent={{95,-105},{135,-65}})));
  PositionChannel channel_x "Measuring channel of the position"
    annotation (Placement(transformation(extent={{160,-105},{200,-65}})));
equation
  connect(ruler.x, channel_x.u)
    annotation (Line(points={{135,-85}, {160,-85}}, color={0,0,127}));
  connect(channel_x.y, x)
    annotation (Line(points={{200,-85}, {230,-85}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p>Left to the extending class: what <code>ruler.flange</code> is fixed to, and <code>channel_x.dynamics</code>, as for
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses.PressureReading\">PressureReading</a>.</p>
</html>"));
end PositionReading;

within PneumaticMuscle.Benches.BaseClasses;
partial model PressureReading "A pressure transducer and its measuring channel"
  extends Icons.Named;
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle or vessel"
    annotation (Placement(transformation(extent={{220,120},{240,140}}),
      iconTransformation(extent={{90,50},{110,70}})));
  replaceable model Manometer = Instruments.Sensors.GaugePressure constrainedby Interfaces.Manometer
    "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model PressureChannel = Instruments.Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-10,110},{30,150}})));
  PressureChannel channel_p "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{100,110},{140,150}})));
equation
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{30,130}, {100,130}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{140,130}, {230,130}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p>Both are replaceable: a fault of the instrument takes the place of one. Left to the extending class: where
<code>manometer.port</code> is tapped, and <code>channel_p.dynamics</code>, which is the ambient's where there is
one.</p>
</html>"));
end PressureReading;

within PneumaticMuscle.Benches.BaseClasses;
partial model TemperatureReading "A thermometer in the gas and its measuring channel"
  extends Icons.Named;
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the muscle or vessel"
    annotation (Placement(transformation(extent={{220,180},{240,200}}),
      iconTransformation(extent={{90,-70},{110,-50}})));
  replaceable model Thermometer = Instruments.Sensors.IdealThermometer constrainedby Interfaces.Thermometer
    "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model TemperatureChannel = Instruments.Sensors.DirectTemperature
    constrainedby Interfaces.TemperatureChannel "Measuring channel of the temperature"
    annotation (choicesAllMatching=true);
  Thermometer thermometer "Thermometer"
    annotation (Placement(transformation(extent={{-50,170},{-10,210}})));
  TemperatureChannel channel_T "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{100,170},{140,210}})));
equation
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-10,190}, {100,190}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{140,190}, {230,190}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p>Left to the extending class: where <code>thermometer.port</code> is, what it reads at the start and what flows past
it, and <code>channel_T.dynamics</code>, as for
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses.PressureReading\">PressureReading</a>.</p>
</html>"));
end TemperatureReading;

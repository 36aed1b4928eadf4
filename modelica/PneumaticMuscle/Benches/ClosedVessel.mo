within PneumaticMuscle.Benches;
model ClosedVessel "A vessel under pressure with everything shut"
  extends Icons.Bench;
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the vessel"
    annotation (Placement(transformation(extent={{100,45},{120,65}}),
      iconTransformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the vessel"
    annotation (Placement(transformation(extent={{100,-45},{120,-25}}),
      iconTransformation(extent={{90,-50},{110,-30}})));
  replaceable model Thermometer = Instruments.Sensors.IdealThermometer constrainedby Interfaces.Thermometer
    "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Instruments.Sensors.GaugePressure constrainedby Interfaces.Manometer
    "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model PressureChannel = Instruments.Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  replaceable model TemperatureChannel = Instruments.Sensors.DirectTemperature
    constrainedby Interfaces.TemperatureChannel "Measuring channel of the temperature"
    annotation (choicesAllMatching=true);
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Pneumatics.Components.Tank tank(V=1e-4, p_start=7e5, startIsReference=true) "Vessel"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-30,60},{10,100}})));
  Thermometer thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-80,60},{-40,100}})));
  PressureChannel channel_p(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-110,-90},{-70,-50}})));
  TemperatureChannel channel_T(dynamics=ambient.dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{-50,-90},{-10,-50}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{10,-90},{50,-50}})));
equation
  connect(tank.port, manometer.port)
    annotation (Line(points={{30,0}, {-10,0}, {-10,60}}, color={0,90,160}));
  connect(tank.port, thermometer.port)
    annotation (Line(points={{30,0}, {-60,0}, {-60,60}}, color={0,90,160}));
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{10,80}, {15,80}, {15,-31}, {-115,-31}, {-115,-70}, {-110,-70}}, color={0,0,127}));
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-40,80}, {-35,80}, {-35,-45}, {-55,-45}, {-55,-70}, {-50,-70}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{-70,-70}, {-64,-70}, {-64,55}, {110,55}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{-10,-70}, {5,-70}, {5,-35}, {110,-35}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-130,-100},{110,120}})),
    experiment(StopTime=150, Interval=0.15, Tolerance=1e-6), Documentation(info="<html>
<p>The test of tightness: fill, shut, and watch the pressure. As it stands nothing changes; what does is an effect. A
leak is found in proportion to the volume: without <code>tank.V</code> only the ratio is known.</p>
</html>"));
end ClosedVessel;

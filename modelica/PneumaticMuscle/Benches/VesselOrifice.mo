within PneumaticMuscle.Benches;
model VesselOrifice "A vessel that empties or fills through a plain orifice"
  extends Icons.Bench;
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the vessel"
    annotation (Placement(transformation(extent={{100,45},{120,65}}),
      iconTransformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the vessel"
    annotation (Placement(transformation(extent={{100,-45},{120,-25}}),
      iconTransformation(extent={{90,-50},{110,-30}})));
  parameter Types.GaugePressure p_outside(min=-1.01e5, max=1e8) = 0 "Gauge pressure outside"
    annotation (Dialog(group="Surroundings"));
  replaceable model PressureChannel = Instruments.Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  replaceable model TemperatureChannel = Instruments.Sensors.DirectTemperature
    constrainedby Interfaces.TemperatureChannel "Measuring channel of the temperature"
    annotation (choicesAllMatching=true);
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  replaceable model Thermometer = Instruments.Sensors.IdealThermometer constrainedby Interfaces.Thermometer
    "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Instruments.Sensors.GaugePressure constrainedby Interfaces.Manometer
    "Pressure transducer"
    annotation (choicesAllMatching=true);
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-130,70},{-90,110}})));
  Pneumatics.Components.Tank tank(V=16.2e-3, p_start=6.9e5, startIsReference=true) "Vessel"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Pneumatics.Components.PlainOrifice orifice "Hole"
    annotation (Placement(transformation(extent={{-20,-20},{-60,20}})));
  Pneumatics.Components.Atmosphere atmosphere(p_gauge=p_outside) "Outside"
    annotation (Placement(transformation(extent={{-130,-20},{-90,20}})));
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-30,60},{10,100}})));
  Thermometer thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-80,60},{-40,100}})));
  PressureChannel channel_p(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-130,-90},{-90,-50}})));
  TemperatureChannel channel_T(dynamics=ambient.dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{-70,-90},{-30,-50}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-10,-90},{30,-50}})));
equation
  connect(tank.port, orifice.port_a)
    annotation (Line(points={{30,0}, {-20,0}}, color={0,90,160}));
  connect(orifice.port_b, atmosphere.port)
    annotation (Line(points={{-60,0}, {-90,0}}, color={0,90,160}));
  connect(tank.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-10,45}, {-10,60}}, color={0,90,160}));
  connect(tank.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-60,45}, {-60,60}}, color={0,90,160}));
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{10,80}, {15,80}, {15,29}, {-135,29}, {-135,-70}, {-130,-70}}, color={0,0,127}));
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-40,80}, {-35,80}, {-35,25}, {-75,25}, {-75,-70}, {-70,-70}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{-90,-70}, {-79,-70}, {-79,-25}, {105,-25}, {105,55}, {110,55}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{-30,-70}, {-15,-70}, {-15,-35}, {110,-35}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-150,-100},{110,120}})),
    experiment(StopTime=60, Interval=0.06, Tolerance=1e-6), Documentation(info="<html>
<p>The polytropic law starts from the state of the vessel: T = T_start (p/p_start)^((n - 1)/n), absolute
pressures.</p>
</html>"));
end VesselOrifice;

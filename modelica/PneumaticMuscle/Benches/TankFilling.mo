within PneumaticMuscle.Benches;
model TankFilling "A tank that is filled and emptied through current-driven valves, DP section 4.4"
  extends Icons.Bench;
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-200,60},{-180,80}}),
      iconTransformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-200,-15},{-180,5}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-200,-90},{-180,-70}}),
      iconTransformation(extent={{-110,-70},{-90,-50}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the tank"
    annotation (Placement(transformation(extent={{100,35},{120,55}}),
      iconTransformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.TemperatureOutput T(displayUnit="degC") "Temperature reading in the tank"
    annotation (Placement(transformation(extent={{100,-65},{120,-45}}),
      iconTransformation(extent={{90,-50},{110,-30}})));
  replaceable model Thermometer = Instruments.Sensors.IdealThermometer constrainedby Interfaces.Thermometer
    "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Instruments.Sensors.GaugePressure constrainedby Interfaces.Manometer
    "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line "Line between valves and tank"
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
    annotation (Placement(transformation(extent={{-170,70},{-130,110}})));
  Pneumatics.Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-170,20},{-130,60}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-170,-60},{-130,-20}})));
  Pneumatics.Components.ValvePair valve "Inlet and exhaust valve"
    annotation (Placement(transformation(extent={{-110,-20},{-70,20}})));
  Line line "Line between valves and tank"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  Pneumatics.Components.Tank tank "Tank"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-50,60},{-10,100}})));
  Thermometer thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-110,60},{-70,100}})));
  PressureChannel channel_p(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-170,-120},{-130,-80}})));
  TemperatureChannel channel_T(dynamics=ambient.dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{-110,-120},{-70,-80}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-50,-120},{-10,-80}})));
equation
  connect(supply.port, valve.supply)
    annotation (Line(points={{-130,40}, {-120,40}, {-120,12}, {-110,12}}, color={0,90,160}));
  connect(valve.port, line.port_a)
    annotation (Line(points={{-70,0}, {-50,0}}, color={0,90,160}));
  connect(line.port_b, tank.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(valve.exhaust, atmosphere.port)
    annotation (Line(points={{-110,-12}, {-120,-12}, {-120,-40}, {-130,-40}}, color={0,90,160}));
  connect(tank.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-30,45}, {-30,60}}, color={0,90,160}));
  connect(tank.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-90,45}, {-90,60}}, color={0,90,160}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-190,-80}, {-175,-80}, {-175,40}, {-170,40}}, color={0,0,127}));
  connect(u_in, valve.u_in)
    annotation (Line(points={{-190,70}, {-175,70}, {-175,65}, {-115,65}, {-115,29}, {-98,29},
      {-98,20}}, color={0,0,127}));
  connect(u_out, valve.u_out)
    annotation (Line(points={{-190,-5}, {-115,-5}, {-115,25}, {-82,25}, {-82,20}}, color={0,0,127}));
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{-10,80}, {-5,80}, {-5,-71}, {-179,-71}, {-179,-100}, {-170,-100}}, color={0,0,127}));
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-70,80}, {-65,80}, {-65,-75}, {-115,-75}, {-115,-100}, {-110,-100}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{-130,-100}, {-119,-100}, {-119,-41}, {105,-41}, {105,45}, {110,45}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{-70,-100}, {-55,-100}, {-55,-55}, {110,-55}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-130},{110,120}})),
    experiment(StopTime=60, Interval=0.06, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (60), (62)-(66), Figs. 4 and 5: eight volumes,
two supplies, 0.35 A. The library's tests hold the times against quadrature.</p>
</html>"));
end TankFilling;

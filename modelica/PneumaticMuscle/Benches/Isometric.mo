within PneumaticMuscle.Benches;
model Isometric "A muscle whose contraction is imposed, driven by current-driven valves; its pull is measured"
  extends Icons.Bench;
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-200,70},{-180,90}}),
      iconTransformation(extent={{-110,65},{-90,85}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-200,-20},{-180,0}}),
      iconTransformation(extent={{-110,15},{-90,35}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-200,-100},{-180,-80}}),
      iconTransformation(extent={{-110,-35},{-90,-15}})));
  Interfaces.Signals.LengthInput s(start=0.02) "Imposed contraction"
    annotation (Placement(transformation(extent={{-200,-190},{-180,-170}}),
      iconTransformation(extent={{-110,-85},{-90,-65}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{100,40},{120,60}}),
      iconTransformation(extent={{90,50},{110,70}})));
  Interfaces.Signals.ForceOutput F "Pull of the muscle"
    annotation (Placement(transformation(extent={{100,-60},{120,-40}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the muscle"
    annotation (Placement(transformation(extent={{100,-160},{120,-140}}),
      iconTransformation(extent={{90,-70},{110,-50}})));
  replaceable model Thermometer = Instruments.Sensors.IdealThermometer constrainedby Interfaces.Thermometer
    "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Instruments.Sensors.GaugePressure constrainedby Interfaces.Manometer
    "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line "Line between valves and muscle"
    annotation (choicesAllMatching=true);
  replaceable model PressureChannel = Instruments.Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  replaceable model ForceChannel = Instruments.Sensors.DirectForce constrainedby Interfaces.ForceChannel
    "Measuring channel of the force"
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
  Line line "Line between valves and muscle"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  Muscles.Components.Muscle muscle "Muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Mechanics.Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs"
    annotation (Placement(transformation(extent={{30,60},{70,100}})));
  Mechanics.Components.ImposedPosition drive "What moves the load end"
    annotation (Placement(transformation(extent={{30,-150},{70,-110}})));
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-50,60},{-10,100}})));
  Thermometer thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-110,60},{-70,100}})));
  Instruments.Sensors.Pull loadCell "Load cell"
    annotation (Placement(transformation(extent={{30,-85},{70,-45}})));
  PressureChannel channel_p(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-170,-210},{-130,-170}})));
  ForceChannel channel_F(dynamics=ambient.dynamics) "Measuring channel of the force"
    annotation (Placement(transformation(extent={{-110,-210},{-70,-170}})));
  TemperatureChannel channel_T(dynamics=ambient.dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{-50,-210},{-10,-170}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{10,-210},{50,-170}})));
equation
  connect(supply.port, valve.supply)
    annotation (Line(points={{-130,40}, {-120,40}, {-120,12}, {-110,12}}, color={0,90,160}));
  connect(valve.port, line.port_a)
    annotation (Line(points={{-70,0}, {-50,0}}, color={0,90,160}));
  connect(line.port_b, muscle.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(valve.exhaust, atmosphere.port)
    annotation (Line(points={{-110,-12}, {-120,-12}, {-120,-40}, {-130,-40}}, color={0,90,160}));
  connect(muscle.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-30,45}, {-30,60}}, color={0,90,160}));
  connect(muscle.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-90,45}, {-90,60}}, color={0,90,160}));
  connect(muscle.flange_a, loadCell.flange_a)
    annotation (Line(points={{50,-20}, {50,-45}}, color={0,110,60}));
  connect(loadCell.flange_b, drive.flange)
    annotation (Line(points={{50,-85}, {50,-110}}, color={0,110,60}));
  connect(muscle.flange_b, ceiling.flange)
    annotation (Line(points={{50,20}, {50,60}}, color={0,110,60}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-190,-90}, {-175,-90}, {-175,40}, {-170,40}}, color={0,0,127}));
  connect(u_in, valve.u_in)
    annotation (Line(points={{-190,80}, {-175,80}, {-175,65}, {-115,65}, {-115,29}, {-98,29},
      {-98,20}}, color={0,0,127}));
  connect(u_out, valve.u_out)
    annotation (Line(points={{-190,-10}, {-124,-10}, {-124,25}, {-82,25}, {-82,20}}, color={0,0,127}));
  connect(s, drive.s_wanted)
    annotation (Line(points={{-190,-180}, {-175,-180}, {-175,-130}, {30,-130}}, color={0,0,127}));
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{-10,80}, {-5,80}, {-5,-126}, {-179,-126}, {-179,-190}, {-170,-190}}, color={0,0,127}));
  connect(loadCell.F, channel_F.u)
    annotation (Line(points={{70,-65}, {75,-65}, {75,-165}, {-115,-165}, {-115,-190}, {-110,-190}}, color={0,0,127}));
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-70,80}, {-55,80}, {-55,-190}, {-50,-190}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{-130,-190}, {-119,-190}, {-119,-40}, {105,-40}, {105,50}, {110,50}}, color={0,0,127}));
  connect(channel_F.y, F)
    annotation (Line(points={{-70,-190}, {-59,-190}, {-59,-90}, {105,-90}, {105,-50}, {110,-50}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{-10,-190}, {5,-190}, {5,-155}, {105,-155}, {105,-150}, {110,-150}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-220},{110,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The muscle of <a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Isotonic</a> between a ceiling and a drive. The
imposed contraction reaches the muscle through a critically damped filter of 5 ms,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.ImposedPosition\">Components.ImposedPosition</a>, because the
speed of the end enters the pressure, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (59). It
starts from zero contraction whatever the input says. The braid carries no push: a negative pull does not occur in a
sleeve, but the base model allows it beyond full contraction, 3 L^2 &lt; b^2.</p>
</html>"));
end Isometric;

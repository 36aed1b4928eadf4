within PneumaticMuscle.Benches;
model Isotonic "A muscle that lifts a hanging mass, driven by current-driven valves, DP Fig. 2"
  extends Icons.Bench;
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-200,50},{-180,70}}),
      iconTransformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-200,-40},{-180,-20}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-200,-130},{-180,-110}}),
      iconTransformation(extent={{-110,-70},{-90,-50}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{140,50},{160,70}}),
      iconTransformation(extent={{90,50},{110,70}})));
  Interfaces.Signals.LengthOutput x "Contraction"
    annotation (Placement(transformation(extent={{140,-40},{160,-20}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the muscle"
    annotation (Placement(transformation(extent={{140,-130},{160,-110}}),
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
  replaceable model PositionChannel = Instruments.Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
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
  Mechanics.Components.Load load(s_start=-load.m*Constants.g/stop.k) "Hanging mass, at rest on the stop"
    annotation (Placement(transformation(extent={{30,-105},{70,-65}})));
  Mechanics.Components.Stop stop(L0=muscle.L0) "Full extension"
    annotation (Placement(transformation(extent={{95,-20},{135,20}})));
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-50,60},{-10,100}})));
  Thermometer thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-110,60},{-70,100}})));
  Instruments.Sensors.Contraction ruler "Displacement transducer"
    annotation (Placement(transformation(extent={{95,-105},{135,-65}})));
  PressureChannel channel_p(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-170,-170},{-130,-130}})));
  PositionChannel channel_x(dynamics=ambient.dynamics) "Measuring channel of the position"
    annotation (Placement(transformation(extent={{-110,-170},{-70,-130}})));
  TemperatureChannel channel_T(dynamics=ambient.dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{-50,-170},{-10,-130}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{10,-170},{50,-130}})));
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
  connect(muscle.flange_a, load.flange)
    annotation (Line(points={{50,-20}, {50,-65}}, color={0,110,60}));
  connect(muscle.flange_b, ceiling.flange)
    annotation (Line(points={{50,20}, {50,60}}, color={0,110,60}));
  connect(muscle.flange_a, stop.flange_a)
    annotation (Line(points={{50,-20}, {50,-40}, {115,-40}, {115,-20}}, color={0,110,60}));
  connect(muscle.flange_b, stop.flange_b)
    annotation (Line(points={{50,20}, {50,40}, {115,40}, {115,20}}, color={0,110,60}));
  connect(muscle.flange_a, ruler.flange)
    annotation (Line(points={{50,-20}, {50,-40}, {80,-40}, {80,-85}, {95,-85}}, color={0,110,60}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-190,-120}, {-179,-120}, {-179,40}, {-170,40}}, color={0,0,127}));
  connect(u_in, valve.u_in)
    annotation (Line(points={{-190,60}, {-175,60}, {-175,65}, {-115,65}, {-115,25}, {-98,25},
      {-98,20}}, color={0,0,127}));
  connect(u_out, valve.u_out)
    annotation (Line(points={{-190,-30}, {-175,-30}, {-175,15}, {-124,15}, {-124,29}, {-82,29},
      {-82,20}}, color={0,0,127}));
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{-10,80}, {-5,80}, {-5,-112}, {-175,-112}, {-175,-150}, {-170,-150}}, color={0,0,127}));
  connect(ruler.x, channel_x.u)
    annotation (Line(points={{135,-85}, {140,-85}, {140,-116}, {-115,-116}, {-115,-150},
      {-110,-150}}, color={0,0,127}));
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-70,80}, {-55,80}, {-55,-150}, {-50,-150}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{-130,-150}, {-119,-150}, {-119,-124}, {145,-124}, {145,60}, {150,60}}, color={0,0,127}));
  connect(channel_x.y, x)
    annotation (Line(points={{-70,-150}, {-59,-150}, {-59,-30}, {150,-30}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{-10,-150}, {5,-150}, {5,-120}, {150,-120}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{150,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> section 3 and Fig. 2, equations DP (17)-(18),
(40)-(42), (44)-(49), (59)-(60), (62), (68)-(71): the base model. The mass rests on the stop of the full length at the
start. By default it is filled from 207 kPa at 0.35 A.</p>
</html>"));
end Isotonic;

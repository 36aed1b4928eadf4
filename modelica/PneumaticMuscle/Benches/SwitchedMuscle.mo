within PneumaticMuscle.Benches;
model SwitchedMuscle "A muscle of imposed contraction that on-off valves fill from a source whose pressure is measured"
  extends Icons.Bench;
  Interfaces.Signals.RealInput u_in(start=1, unit="1") "Command of the inlet valve: 0 shut, 1 open"
    annotation (Placement(transformation(extent={{-200,75},{-180,95}}),
      iconTransformation(extent={{-110,65},{-90,85}})));
  Interfaces.Signals.RealInput u_out(start=0, unit="1") "Command of the exhaust valve: 0 shut, 1 open"
    annotation (Placement(transformation(extent={{-200,5},{-180,25}}),
      iconTransformation(extent={{-110,15},{-90,35}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=500e3, min=-101e3) "Gauge pressure of the source, as it droops"
    annotation (Placement(transformation(extent={{-200,-65},{-180,-45}}),
      iconTransformation(extent={{-110,-35},{-90,-15}})));
  Interfaces.Signals.LengthInput s(start=0.02) "Imposed contraction"
    annotation (Placement(transformation(extent={{-200,-135},{-180,-115}}),
      iconTransformation(extent={{-110,-85},{-90,-65}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{100,25},{120,45}}),
      iconTransformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the muscle"
    annotation (Placement(transformation(extent={{100,-85},{120,-65}}),
      iconTransformation(extent={{90,-50},{110,-30}})));
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
  replaceable model TemperatureChannel = Instruments.Sensors.DirectTemperature
    constrainedby Interfaces.TemperatureChannel "Measuring channel of the temperature"
    annotation (choicesAllMatching=true);
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-170,70},{-130,110}})));
  Pneumatics.Components.Supply supply "Source"
    annotation (Placement(transformation(extent={{-170,20},{-130,60}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-170,-60},{-130,-20}})));
  Pneumatics.Components.ValvePair valve(u_in=u_open*u_in, u_out=u_open*u_out, C_A=0.2) "Inlet and exhaust valve"
    annotation (Placement(transformation(extent={{-110,-20},{-70,20}})));
  Line line "Line between valves and muscle"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  Muscles.Components.Muscle muscle "Muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Mechanics.Components.Fixed ceiling(s0=muscle.L0) "Where the muscle is fixed"
    annotation (Placement(transformation(extent={{30,60},{70,100}})));
  Mechanics.Components.ImposedPosition drive(tau=1e-3) "What moves the load end"
    annotation (Placement(transformation(extent={{30,-95},{70,-55}})));
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-50,60},{-10,100}})));
  Thermometer thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-110,60},{-70,100}})));
  PressureChannel channel_p(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-170,-150},{-130,-110}})));
  TemperatureChannel channel_T(dynamics=ambient.dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{-110,-150},{-70,-110}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-50,-150},{-10,-110}})));
protected
  constant Types.Current u_open = (1e-5 + 2.61e-7)/1.80e-6 "Current at which DP (62) opens 10 mm2";
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
  connect(muscle.flange_a, drive.flange)
    annotation (Line(points={{50,-20}, {50,-55}}, color={0,110,60}));
  connect(muscle.flange_b, ceiling.flange)
    annotation (Line(points={{50,20}, {50,60}}, color={0,110,60}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-190,-55}, {-175,-55}, {-175,40}, {-170,40}}, color={0,0,127}));
  connect(s, drive.s_wanted)
    annotation (Line(points={{-190,-125}, {-175,-125}, {-175,-75}, {30,-75}}, color={0,0,127}));
  connect(manometer.p, channel_p.u)
    annotation (Line(points={{-10,80}, {-5,80}, {-5,-71}, {-179,-71}, {-179,-130}, {-170,-130}}, color={0,0,127}));
  connect(thermometer.T, channel_T.u)
    annotation (Line(points={{-70,80}, {-65,80}, {-65,-105}, {-115,-105}, {-115,-130}, {-110,-130}}, color={0,0,127}));
  connect(channel_p.y, p)
    annotation (Line(points={{-130,-130}, {-119,-130}, {-119,-41}, {105,-41}, {105,35}, {110,35}}, color={0,0,127}));
  connect(channel_T.y, T)
    annotation (Line(points={{-70,-130}, {-55,-130}, {-55,-100}, {105,-100}, {105,-75}, {110,-75}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-160},{110,120}})),
    experiment(StopTime=0.5, Interval=0.001, Tolerance=1e-6), Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Benches.Isometric\">Isometric</a> with valves that are open or shut: a
command of 1 opens 10 <code>valve.C_A</code> mm2, so that <code>valve.C_A</code> is the effective area of the open
valve. A finite tank needs no model of its own where the pressure before the valve is measured: it is the input
<code>p_supply</code>, with its droop. The contraction passes a critically damped filter of 1 ms,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.ImposedPosition\">Components.ImposedPosition</a>.</p>
</html>"));
end SwitchedMuscle;

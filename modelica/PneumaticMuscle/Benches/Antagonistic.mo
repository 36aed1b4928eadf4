within PneumaticMuscle.Benches;
model Antagonistic "Two muscles that pull a pulley against each other"
  extends Icons.Bench;
  Interfaces.Signals.CurrentInput u_in_1(start=0.35) "Current of the first inlet valve"
    annotation (Placement(transformation(extent={{-260,95},{-240,115}}),
      iconTransformation(extent={{-110,70},{-90,90}})));
  Interfaces.Signals.CurrentInput u_out_1(start=0) "Current of the first exhaust valve"
    annotation (Placement(transformation(extent={{-260,30},{-240,50}}),
      iconTransformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.CurrentInput u_in_2(start=0.25) "Current of the second inlet valve"
    annotation (Placement(transformation(extent={{-260,-35},{-240,-15}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.CurrentInput u_out_2(start=0.25) "Current of the second exhaust valve"
    annotation (Placement(transformation(extent={{-260,-100},{-240,-80}}),
      iconTransformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-260,-165},{-240,-145}}),
      iconTransformation(extent={{-110,-90},{-90,-70}})));
  Interfaces.Signals.GaugePressureOutput p_1 "Gauge pressure in the first muscle"
    annotation (Placement(transformation(extent={{240,65},{260,85}}),
      iconTransformation(extent={{90,50},{110,70}})));
  Interfaces.Signals.GaugePressureOutput p_2 "Gauge pressure in the second muscle"
    annotation (Placement(transformation(extent={{240,-35},{260,-15}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Interfaces.Signals.LengthOutput x "Travel of the rim, towards the first muscle"
    annotation (Placement(transformation(extent={{240,-135},{260,-115}}),
      iconTransformation(extent={{90,-70},{110,-50}})));
  replaceable model Manometer = Instruments.Sensors.GaugePressure constrainedby Interfaces.Manometer
    "Pressure transducers"
    annotation (choicesAllMatching=true);
  replaceable model PressureChannel = Instruments.Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  replaceable model PositionChannel = Instruments.Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
    annotation (choicesAllMatching=true);
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-20,60},{20,100}})));
  Pneumatics.Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-240,90},{-200,130}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-240,-130},{-200,-90}})));
  Pneumatics.Components.ValvePair valve_1 "Valves of the first muscle"
    annotation (Placement(transformation(extent={{-180,-20},{-140,20}})));
  Pneumatics.Components.ValvePair valve_2 "Valves of the second muscle"
    annotation (Placement(transformation(extent={{180,-20},{140,20}})));
  Muscles.Components.Muscle muscle_1 "First muscle"
    annotation (Placement(transformation(extent={{-100,-20},{-60,20}})));
  Muscles.Components.Muscle muscle_2 "Second muscle"
    annotation (Placement(transformation(extent={{100,-20},{60,20}})));
  Mechanics.Components.Fixed frame_1(s0=muscle_1.L0) "Where the first muscle is fixed"
    annotation (Placement(transformation(extent={{-100,55},{-60,95}})));
  Mechanics.Components.Fixed frame_2(s0=muscle_2.L0) "Where the second muscle is fixed"
    annotation (Placement(transformation(extent={{60,55},{100,95}})));
  Mechanics.Components.Stop stop_1(L0=muscle_1.L0) "Full extension of the first muscle"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  Mechanics.Components.Stop stop_2(L0=muscle_2.L0) "Full extension of the second muscle"
    annotation (Placement(transformation(extent={{10,-20},{50,20}})));
  Mechanics.Components.Pulley pulley "Pulley"
    annotation (Placement(transformation(extent={{-20,-100},{20,-60}})));
  Manometer manometer_1 "Pressure transducer"
    annotation (Placement(transformation(extent={{-140,55},{-100,95}})));
  Manometer manometer_2 "Pressure transducer"
    annotation (Placement(transformation(extent={{100,55},{140,95}})));
  PressureChannel channel_p_1(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-230,-180},{-190,-140}})));
  PressureChannel channel_p_2(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-170,-180},{-130,-140}})));
  PositionChannel channel_x(u=pulley.r*pulley.phi, dynamics=ambient.dynamics) "Measuring channel of the position"
    annotation (Placement(transformation(extent={{-110,-180},{-70,-140}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-50,-180},{-10,-140}})));
equation
  connect(supply.port, valve_1.supply)
    annotation (Line(points={{-200,110}, {-190,110}, {-190,12}, {-180,12}}, color={0,90,160}));
  connect(supply.port, valve_2.supply)
    annotation (Line(points={{-200,110}, {190,110}, {190,12}, {180,12}}, color={0,90,160}));
  connect(valve_1.port, muscle_1.port)
    annotation (Line(points={{-140,0}, {-100,0}}, color={0,90,160}));
  connect(valve_2.port, muscle_2.port)
    annotation (Line(points={{140,0}, {100,0}}, color={0,90,160}));
  connect(valve_1.exhaust, atmosphere.port)
    annotation (Line(points={{-180,-12}, {-190,-12}, {-190,-110}, {-200,-110}}, color={0,90,160}));
  connect(valve_2.exhaust, atmosphere.port)
    annotation (Line(points={{180,-12}, {190,-12}, {190,-110}, {-200,-110}}, color={0,90,160}));
  connect(muscle_1.port, manometer_1.port)
    annotation (Line(points={{-100,0}, {-120,0}, {-120,55}}, color={0,90,160}));
  connect(muscle_2.port, manometer_2.port)
    annotation (Line(points={{100,0}, {120,0}, {120,55}}, color={0,90,160}));
  connect(muscle_1.flange_a, pulley.flange_1)
    annotation (Line(points={{-80,-20}, {-80,-40}, {-12,-40}, {-12,-60}}, color={0,110,60}));
  connect(muscle_2.flange_a, pulley.flange_2)
    annotation (Line(points={{80,-20}, {80,-40}, {12,-40}, {12,-60}}, color={0,110,60}));
  connect(muscle_1.flange_b, frame_1.flange)
    annotation (Line(points={{-80,20}, {-80,55}}, color={0,110,60}));
  connect(muscle_2.flange_b, frame_2.flange)
    annotation (Line(points={{80,20}, {80,55}}, color={0,110,60}));
  connect(muscle_1.flange_a, stop_1.flange_a)
    annotation (Line(points={{-80,-20}, {-80,-40}, {-30,-40}, {-30,-20}}, color={0,110,60}));
  connect(muscle_1.flange_b, stop_1.flange_b)
    annotation (Line(points={{-80,20}, {-80,40}, {-30,40}, {-30,20}}, color={0,110,60}));
  connect(muscle_2.flange_a, stop_2.flange_a)
    annotation (Line(points={{80,-20}, {80,-40}, {30,-40}, {30,-20}}, color={0,110,60}));
  connect(muscle_2.flange_b, stop_2.flange_b)
    annotation (Line(points={{80,20}, {80,40}, {30,40}, {30,20}}, color={0,110,60}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-250,-155}, {-245,-155}, {-245,21}, {-241,21}, {-241,110}, {-240,110}}, color={0,0,127}));
  connect(u_in_1, valve_1.u_in)
    annotation (Line(points={{-250,105}, {-245,105}, {-245,25}, {-168,25}, {-168,20}}, color={0,0,127}));
  connect(u_out_1, valve_1.u_out)
    annotation (Line(points={{-250,40}, {-152,40}, {-152,20}}, color={0,0,127}));
  connect(u_in_2, valve_2.u_in)
    annotation (Line(points={{-250,-25}, {135,-25}, {135,25}, {168,25}, {168,20}}, color={0,0,127}));
  connect(u_out_2, valve_2.u_out)
    annotation (Line(points={{-250,-90}, {-241,-90}, {-241,-44}, {131,-44}, {131,29}, {152,29},
      {152,20}}, color={0,0,127}));
  connect(manometer_1.p, channel_p_1.u)
    annotation (Line(points={{-100,75}, {-100,25}, {-135,25}, {-135,-135}, {-235,-135}, {-235,-160},
      {-230,-160}}, color={0,0,127}));
  connect(manometer_2.p, channel_p_2.u)
    annotation (Line(points={{140,75}, {145,75}, {145,33}, {124,33}, {124,-106}, {-175,-106}, {-175,-160},
      {-170,-160}}, color={0,0,127}));
  connect(channel_p_1.y, p_1)
    annotation (Line(points={{-190,-160}, {-179,-160}, {-179,-118}, {241,-118}, {241,75}, {250,75}}, color={0,0,127}));
  connect(channel_p_2.y, p_2)
    annotation (Line(points={{-130,-160}, {-115,-160}, {-115,-114}, {245,-114}, {245,-25},
      {250,-25}}, color={0,0,127}));
  connect(channel_x.y, x)
    annotation (Line(points={{-70,-160}, {-55,-160}, {-55,-125}, {250,-125}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-250,-190},{250,140}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Two muscles of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> on a pulley, each with its valves;
both are contracted by <code>pulley.x_0</code> in the middle position, so that each has room to extend. They fill alike
in volume and pressure until the one that is filled faster turns the pulley; the angle is x/<code>pulley.r</code>.</p>
</html>"));
end Antagonistic;

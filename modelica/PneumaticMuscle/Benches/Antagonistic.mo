within PneumaticMuscle.Benches;
model Antagonistic "Two muscles that pull a pulley against each other"
  extends Interfaces.Rig;
  Interfaces.Signals.CurrentInput u_in_1(start=0.35) "Current of the first inlet valve"
    annotation (Placement(transformation(extent={{-260,35},{-240,55}}),
      iconTransformation(extent={{-110,70},{-90,90}})));
  Interfaces.Signals.CurrentInput u_out_1(start=0) "Current of the first exhaust valve"
    annotation (Placement(transformation(extent={{-260,-30},{-240,-10}}),
      iconTransformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.CurrentInput u_in_2(start=0.25) "Current of the second inlet valve"
    annotation (Placement(transformation(extent={{-260,-95},{-240,-75}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.CurrentInput u_out_2(start=0.25) "Current of the second exhaust valve"
    annotation (Placement(transformation(extent={{-260,-160},{-240,-140}}),
      iconTransformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-260,-225},{-240,-205}}),
      iconTransformation(extent={{-110,-90},{-90,-70}})));
  Interfaces.Signals.GaugePressureOutput p_1 "Gauge pressure in the first muscle"
    annotation (Placement(transformation(extent={{240,5},{260,25}}),
      iconTransformation(extent={{90,50},{110,70}})));
  Interfaces.Signals.GaugePressureOutput p_2 "Gauge pressure in the second muscle"
    annotation (Placement(transformation(extent={{240,-95},{260,-75}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Interfaces.Signals.LengthOutput x "Travel of the rim, towards the first muscle"
    annotation (Placement(transformation(extent={{240,-195},{260,-175}}),
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
  Pneumatics.Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-240,30},{-200,70}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-240,-190},{-200,-150}})));
  Pneumatics.Components.ValvePair valve_1 "Valves of the first muscle"
    annotation (Placement(transformation(extent={{-180,-80},{-140,-40}})));
  Pneumatics.Components.ValvePair valve_2 "Valves of the second muscle"
    annotation (Placement(transformation(extent={{180,-80},{140,-40}})));
  Muscles.Components.Muscle muscle_1 "First muscle"
    annotation (Placement(transformation(extent={{-100,-80},{-60,-40}})));
  Muscles.Components.Muscle muscle_2 "Second muscle"
    annotation (Placement(transformation(extent={{100,-80},{60,-40}})));
  Mechanics.Components.Fixed frame_1(s0=muscle_1.L0) "Where the first muscle is fixed"
    annotation (Placement(transformation(extent={{-100,-5},{-60,35}})));
  Mechanics.Components.Fixed frame_2(s0=muscle_2.L0) "Where the second muscle is fixed"
    annotation (Placement(transformation(extent={{60,-5},{100,35}})));
  Mechanics.Components.Stop stop_1(L0=muscle_1.L0) "Full extension of the first muscle"
    annotation (Placement(transformation(extent={{-50,-80},{-10,-40}})));
  Mechanics.Components.Stop stop_2(L0=muscle_2.L0) "Full extension of the second muscle"
    annotation (Placement(transformation(extent={{10,-80},{50,-40}})));
  Mechanics.Components.Pulley pulley "Pulley"
    annotation (Placement(transformation(extent={{-20,-160},{20,-120}})));
  Manometer manometer_1 "Pressure transducer"
    annotation (Placement(transformation(extent={{-140,-5},{-100,35}})));
  Manometer manometer_2 "Pressure transducer"
    annotation (Placement(transformation(extent={{100,-5},{140,35}})));
  PressureChannel channel_p_1(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-230,-240},{-190,-200}})));
  PressureChannel channel_p_2(dynamics=ambient.dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-170,-240},{-130,-200}})));
  PositionChannel channel_x(u=pulley.r*pulley.phi, dynamics=ambient.dynamics) "Measuring channel of the position"
    annotation (Placement(transformation(extent={{-110,-240},{-70,-200}})));
equation
  connect(supply.port, valve_1.supply)
    annotation (Line(points={{-200,50}, {-190,50}, {-190,-48}, {-180,-48}}, color={0,90,160}));
  connect(supply.port, valve_2.supply)
    annotation (Line(points={{-200,50}, {190,50}, {190,-48}, {180,-48}}, color={0,90,160}));
  connect(valve_1.port, muscle_1.port)
    annotation (Line(points={{-140,-60}, {-100,-60}}, color={0,90,160}));
  connect(valve_2.port, muscle_2.port)
    annotation (Line(points={{140,-60}, {100,-60}}, color={0,90,160}));
  connect(valve_1.exhaust, atmosphere.port)
    annotation (Line(points={{-180,-72}, {-190,-72}, {-190,-170}, {-200,-170}}, color={0,90,160}));
  connect(valve_2.exhaust, atmosphere.port)
    annotation (Line(points={{180,-72}, {190,-72}, {190,-170}, {-200,-170}}, color={0,90,160}));
  connect(muscle_1.port, manometer_1.port)
    annotation (Line(points={{-100,-60}, {-120,-60}, {-120,-5}}, color={0,90,160}));
  connect(muscle_2.port, manometer_2.port)
    annotation (Line(points={{100,-60}, {120,-60}, {120,-5}}, color={0,90,160}));
  connect(muscle_1.flange_a, pulley.flange_1)
    annotation (Line(points={{-80,-80}, {-80,-100}, {-12,-100}, {-12,-120}}, color={0,110,60}));
  connect(muscle_2.flange_a, pulley.flange_2)
    annotation (Line(points={{80,-80}, {80,-100}, {12,-100}, {12,-120}}, color={0,110,60}));
  connect(muscle_1.flange_b, frame_1.flange)
    annotation (Line(points={{-80,-40}, {-80,-5}}, color={0,110,60}));
  connect(muscle_2.flange_b, frame_2.flange)
    annotation (Line(points={{80,-40}, {80,-5}}, color={0,110,60}));
  connect(muscle_1.flange_a, stop_1.flange_a)
    annotation (Line(points={{-80,-80}, {-80,-100}, {-30,-100}, {-30,-80}}, color={0,110,60}));
  connect(muscle_1.flange_b, stop_1.flange_b)
    annotation (Line(points={{-80,-40}, {-80,-20}, {-30,-20}, {-30,-40}}, color={0,110,60}));
  connect(muscle_2.flange_a, stop_2.flange_a)
    annotation (Line(points={{80,-80}, {80,-100}, {30,-100}, {30,-80}}, color={0,110,60}));
  connect(muscle_2.flange_b, stop_2.flange_b)
    annotation (Line(points={{80,-40}, {80,-20}, {30,-20}, {30,-40}}, color={0,110,60}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-250,-215}, {-245,-215}, {-245,-39}, {-241,-39}, {-241,50}, {-240,50}}, color={0,0,127}));
  connect(u_in_1, valve_1.u_in)
    annotation (Line(points={{-250,45}, {-245,45}, {-245,-35}, {-168,-35}, {-168,-40}}, color={0,0,127}));
  connect(u_out_1, valve_1.u_out)
    annotation (Line(points={{-250,-20}, {-152,-20}, {-152,-40}}, color={0,0,127}));
  connect(u_in_2, valve_2.u_in)
    annotation (Line(points={{-250,-85}, {135,-85}, {135,-35}, {168,-35}, {168,-40}}, color={0,0,127}));
  connect(u_out_2, valve_2.u_out)
    annotation (Line(points={{-250,-150}, {-241,-150}, {-241,-104}, {131,-104}, {131,-31}, {152,-31},
      {152,-40}}, color={0,0,127}));
  connect(manometer_1.p, channel_p_1.u)
    annotation (Line(points={{-100,15}, {-100,-35}, {-135,-35}, {-135,-195}, {-235,-195}, {-235,-220},
      {-230,-220}}, color={0,0,127}));
  connect(manometer_2.p, channel_p_2.u)
    annotation (Line(points={{140,15}, {145,15}, {145,-27}, {124,-27}, {124,-166}, {-175,-166}, {-175,-220},
      {-170,-220}}, color={0,0,127}));
  connect(channel_p_1.y, p_1)
    annotation (Line(points={{-190,-220}, {-179,-220}, {-179,-178}, {241,-178}, {241,15}, {250,15}}, color={0,0,127}));
  connect(channel_p_2.y, p_2)
    annotation (Line(points={{-130,-220}, {-115,-220}, {-115,-174}, {245,-174}, {245,-85},
      {250,-85}}, color={0,0,127}));
  connect(channel_x.y, x)
    annotation (Line(points={{-70,-220}, {-55,-220}, {-55,-185}, {250,-185}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-250,-250},{250,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Two muscles of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> on a pulley, each with its valves;
both are contracted by <code>pulley.x_0</code> in the middle position, so that each has room to extend. They fill alike
in volume and pressure until the one that is filled faster turns the pulley; the angle is x/<code>pulley.r</code>.</p>
</html>"));
end Antagonistic;

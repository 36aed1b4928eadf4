within PneumaticMuscle.Examples;
partial model ReviewedBench "A bench for the laws that the papers review"
  extends Icons.Example;
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-200,60},{-180,80}}),
      iconTransformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-200,-15},{-180,5}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-200,-90},{-180,-70}}),
      iconTransformation(extent={{-110,-70},{-90,-50}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{140,35},{160,55}}),
      iconTransformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.LengthOutput x "Contraction"
    annotation (Placement(transformation(extent={{140,-65},{160,-45}}),
      iconTransformation(extent={{90,-50},{110,-30}})));
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-170,70},{-130,110}})));
  Pneumatics.Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-170,20},{-130,60}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-170,-60},{-130,-20}})));
  Pneumatics.Components.ReviewedValves valve "Inlet and exhaust valve"
    annotation (Placement(transformation(extent={{-110,-20},{-70,20}})));
  Muscles.Components.ReviewedMuscle muscle "Muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Mechanics.Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs"
    annotation (Placement(transformation(extent={{30,60},{70,100}})));
  Mechanics.Components.Load load(s_start=-load.m*Constants.g/stop.k) "Hanging mass, at rest on the stop"
    annotation (Placement(transformation(extent={{30,-105},{70,-65}})));
  Mechanics.Components.Stop stop(L0=muscle.L0) "Full extension"
    annotation (Placement(transformation(extent={{95,-20},{135,20}})));
  Instruments.Sensors.GaugePressure manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-50,60},{-10,100}})));
  Instruments.Sensors.Contraction ruler "Displacement transducer"
    annotation (Placement(transformation(extent={{95,-105},{135,-65}})));
equation
  connect(supply.port, valve.supply)
    annotation (Line(points={{-130,40}, {-120,40}, {-120,12}, {-110,12}}, color={0,90,160}));
  connect(valve.port, muscle.port)
    annotation (Line(points={{-70,0}, {30,0}}, color={0,90,160}));
  connect(valve.exhaust, atmosphere.port)
    annotation (Line(points={{-110,-12}, {-120,-12}, {-120,-40}, {-130,-40}}, color={0,90,160}));
  connect(muscle.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,45}, {-30,45}, {-30,60}}, color={0,90,160}));
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
    annotation (Line(points={{-190,-80}, {-175,-80}, {-175,40}, {-170,40}}, color={0,0,127}));
  connect(u_in, valve.u_in)
    annotation (Line(points={{-190,70}, {-175,70}, {-175,65}, {-98,65}, {-98,20}}, color={0,0,127}));
  connect(u_out, valve.u_out)
    annotation (Line(points={{-190,-5}, {-115,-5}, {-115,25}, {-82,25}, {-82,20}}, color={0,0,127}));
  connect(manometer.p, p)
    annotation (Line(points={{-10,80}, {25,80}, {25,45}, {150,45}}, color={0,0,127}));
  connect(ruler.x, x)
    annotation (Line(points={{135,-85}, {145,-85}, {145,-55}, {150,-55}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-130},{150,120}})),
    Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Benches.Isotonic</a> with a
<a href=\"modelica://PneumaticMuscle.Muscles.Components.ReviewedMuscle\">Components.ReviewedMuscle</a>. The law of force
must be chosen: <code>extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord))</code>.</p>
</html>"));
end ReviewedBench;

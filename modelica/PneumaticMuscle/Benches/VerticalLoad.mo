within PneumaticMuscle.Benches;
model VerticalLoad "The empirical muscle with a hanging load, driven by pressure, DY Fig. 1"
  extends Icons.Bench;
  Interfaces.Signals.GaugePressureInput p(start=200e3) "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{-110,-40},{-90,-20}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.LengthOutput x "Contraction"
    annotation (Placement(transformation(extent={{140,20},{160,40}}),
      iconTransformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.RealOutput eps(unit="1") "Contraction ratio"
    annotation (Placement(transformation(extent={{140,-100},{160,-80}}),
      iconTransformation(extent={{90,-50},{110,-30}})));
  replaceable model PositionChannel = Instruments.Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
    annotation (choicesAllMatching=true);
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  parameter Real frequency(unit="Hz", min=0.01, max=100) = 0.5 "Frequency of the excitation"
    annotation (Dialog(group="Load"));
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-80,65},{-40,105}})));
  inner Excitation excitation(F_load=load.m*Constants.g, frequency=frequency) "Load and frequency of the run"
    annotation (Placement(transformation(extent={{-80,-105},{-40,-65}})));
  Pneumatics.Components.Regulator regulator "Pressure regulator"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  Muscles.Components.EmpiricalMuscle muscle "Muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Mechanics.Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs"
    annotation (Placement(transformation(extent={{30,60},{70,100}})));
  Mechanics.Components.Load load(m=10, s_start=muscle.elasticity.x_rest) "Hanging mass, at rest without pressure"
    annotation (Placement(transformation(extent={{30,-105},{70,-65}})));
  Instruments.Sensors.Contraction ruler "Displacement transducer"
    annotation (Placement(transformation(extent={{95,-105},{135,-65}})));
  PositionChannel channel_x(dynamics=ambient.dynamics) "Measuring channel of the position"
    annotation (Placement(transformation(extent={{-80,-170},{-40,-130}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{-20,-170},{20,-130}})));
equation
  connect(regulator.port, muscle.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(muscle.flange_a, load.flange)
    annotation (Line(points={{50,-20}, {50,-65}}, color={0,110,60}));
  connect(muscle.flange_b, ceiling.flange)
    annotation (Line(points={{50,20}, {50,60}}, color={0,110,60}));
  connect(muscle.flange_a, ruler.flange)
    annotation (Line(points={{50,-20}, {50,-40}, {80,-40}, {80,-85}, {95,-85}}, color={0,110,60}));
  eps = x/muscle.L0;
  connect(p, regulator.p_wanted)
    annotation (Line(points={{-100,-30}, {-55,-30}, {-55,0}, {-50,0}}, color={0,0,127}));
  connect(ruler.x, channel_x.u)
    annotation (Line(points={{135,-85}, {140,-85}, {140,-125}, {-85,-125}, {-85,-150}, {-80,-150}}, color={0,0,127}));
  connect(channel_x.y, x)
    annotation (Line(points={{-40,-150}, {-25,-150}, {-25,-110}, {145,-110}, {145,30}, {150,30}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-100,-180},{150,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>M L eps_ddot = F_s(P, eps) - F_elastic - F_hys - M g,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (13)-(16), with x = L eps. Load (5 to 30 kg) and
frequency (0.5 to 2 Hz) are constants of a run. The sign of the speed is rounded
(<a href=\"modelica://PneumaticMuscle.Laws.Frictions.CoulombViscous\">Laws.Frictions.CoulombViscous</a>). Only the
product of <code>muscle.friction.a</code> and <code>muscle.friction.b_f</code> can be found from measurements: keep one
fixed. <a href=\"modelica://PneumaticMuscle.Examples.PrintedSleeveLoad\">Examples.PrintedSleeveLoad</a> has DY (12) as
printed, <a href=\"modelica://PneumaticMuscle.Examples.ConstantFrictionLoad\">Examples.ConstantFrictionLoad</a> friction
of constant coefficients, <a href=\"modelica://PneumaticMuscle.Examples.LongMuscle\">Examples.LongMuscle</a> the longer
of DY's muscles.</p>
</html>"));
end VerticalLoad;

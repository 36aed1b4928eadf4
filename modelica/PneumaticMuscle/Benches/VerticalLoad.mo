within PneumaticMuscle.Benches;
model VerticalLoad "The empirical muscle with a hanging load, driven by pressure, DY Fig. 1"
  extends Interfaces.LoadedRig(final F_start=load.m*Constants.g);
  extends BaseClasses.HungMuscle(redeclare Muscles.Components.EmpiricalMuscle muscle);
  extends BaseClasses.PositionReading(channel_x(dynamics=ambient.dynamics));
  Interfaces.Signals.GaugePressureInput p(start=200e3) "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{-200,-10},{-180,10}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.RealOutput eps(unit="1") "Contraction ratio"
    annotation (Placement(transformation(extent={{220,-150},{240,-130}}),
      iconTransformation(extent={{90,-70},{110,-50}})));
  Pneumatics.Components.Regulator regulator "Pressure regulator"
    annotation (Placement(transformation(extent={{-110,-20},{-70,20}})));
  Mechanics.Components.Load load(m=10, s_start=muscle.elasticity.x_rest) "Hanging mass, at rest without pressure"
    annotation (Placement(transformation(extent={{30,-105},{70,-65}})));
equation
  eps = x/muscle.L0;
  connect(regulator.port, muscle.port)
    annotation (Line(points={{-70,0}, {30,0}}, color={0,90,160}));
  connect(muscle.flange_a, load.flange)
    annotation (Line(points={{50,-20}, {50,-65}}, color={0,110,60}));
  connect(muscle.flange_a, ruler.flange)
    annotation (Line(points={{50,-20}, {50,-40}, {80,-40}, {80,-85}, {95,-85}}, color={0,110,60}));
  connect(p, regulator.p_wanted)
    annotation (Line(points={{-190,0}, {-110,0}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
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

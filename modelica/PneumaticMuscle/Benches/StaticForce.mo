within PneumaticMuscle.Benches;
model StaticForce "Pull of a muscle by pressure and contraction ratio, without any motion, AM Figs. 4-6"
  extends Interfaces.Rig;
  Interfaces.Signals.GaugePressureInput p(start=6e5) "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{-200,20},{-180,40}}),
      iconTransformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.RealInput eps(start=0.1, unit="1") "Contraction ratio"
    annotation (Placement(transformation(extent={{-200,-70},{-180,-50}}),
      iconTransformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.ForceOutput F "Pull of the muscle"
    annotation (Placement(transformation(extent={{220,-10},{240,10}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  replaceable model ForceChannel = Instruments.Sensors.DirectForce constrainedby Interfaces.ForceChannel
    "Measuring channel of the force"
    annotation (choicesAllMatching=true);
  Muscles.Components.HeldMuscle muscle "Muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  ForceChannel channel_F(u=muscle.F, dynamics=ambient.dynamics) "Measuring channel of the force"
    annotation (Placement(transformation(extent={{100,-20},{140,20}})));
equation
  connect(p, muscle.p_gauge)
    annotation (Line(points={{-190,30}, {10,30}, {10,8}, {30,8}}, color={0,0,127}));
  connect(eps, muscle.eps)
    annotation (Line(points={{-190,-60}, {10,-60}, {10,-8}, {30,-8}}, color={0,0,127}));
  connect(channel_F.y, F)
    annotation (Line(points={{140,0}, {230,0}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-110},{230,120}})),
    experiment(StopTime=1, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equations 1 to 3: Kang's force
with q = 1 + 3 exp(-2e-6 P), D0 = 1 cm, 23 degrees, 30 cm. Each sample of the inputs is a point of a data sheet's grid
of force by pressure and contraction, so a grid can be compared and fitted as if it were a time series.</p>
<p>About 6 bar and 10 % strain the stated parameters give F = 205.67 N, dF/dP = 5.7239e-4 m2 and dF/dL = 8061.8 N/m. AM
Fig. 7 has 5.7238e-5 and 8061.8: the stiffness is confirmed, the other coefficient is ten times too small in print.</p>
</html>"));
end StaticForce;

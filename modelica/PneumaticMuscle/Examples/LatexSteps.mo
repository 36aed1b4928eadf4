within PneumaticMuscle.Examples;
model LatexSteps "The latex muscle is inflated and deflated, DP Figs. 8, 10 and 12"
  extends Icons.Example;
  output Types.GaugePressure p = bench.p "Gauge pressure in the muscle";
  output Types.Length x = bench.x "Contraction";
  output Types.Temperature T = bench.T "Temperature in the muscle";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Benches.Isotonic bench(p_supply=207e3) "Muscle with hanging mass"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(inlet.y, bench.u_in)
    annotation (Line(points={{-30,40}, {25,40}, {25,12}, {30,12}}, color={0,0,127}));
  connect(outlet.y, bench.u_out)
    annotation (Line(points={{-30,-40}, {25,-40}, {25,0}, {30,0}}, color={0,0,127}));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Inflation from 207 kPa at 0.35 A for 5 s, then deflation, 2.27 kg,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> section 6.</p>
</html>"));
end LatexSteps;

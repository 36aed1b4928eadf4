within PneumaticMuscle.Examples;
model ButylSteps "The butyl muscle is inflated and deflated, DP Figs. 7, 9 and 11"
  extends Icons.Example;
  output Types.GaugePressure p = bench.p "Gauge pressure in the muscle";
  output Types.Length x = bench.x "Contraction";
  output Types.Temperature T = bench.T "Temperature in the muscle";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  ButylIsotonic bench(u_in=inlet.y, u_out=outlet.y, p_supply=207e3) "Muscle with hanging mass"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Examples.LatexSteps\">LatexSteps</a> with
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 2. The model contracts at once; DP measure a
gradual contraction.</p>
</html>"));
end ButylSteps;

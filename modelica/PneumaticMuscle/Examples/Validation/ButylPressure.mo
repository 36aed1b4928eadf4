within PneumaticMuscle.Examples.Validation;
model ButylPressure
  "Pressure and contraction of the butyl muscle for n_g = 1, 1.2, 1.4, and its length of the text, DP Figs. 7 and 9"
  extends Icons.Validation;
  constant Real n_g[3](each unit="1") = {1, 1.2, 1.4} "Polytropic exponents";
  output Types.GaugePressure p[3] = bench.p "Gauge pressures";
  output Types.Length x[3] = bench.x "Contractions";
  output Types.GaugePressure p_long = long.p "Gauge pressure with the length of the text";
  output Types.Length x_long = long.x "Contraction with the length of the text";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Examples.ButylIsotonic bench[3](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3, muscle(n_g=n_g))
    "DP Table 2: 0.23 m"
    annotation (Placement(transformation(extent={{30,20},{70,60}})));
  Examples.ButylIsotonic long(u_in=inlet.y, u_out=outlet.y, p_supply=207e3, muscle(L0=0.24)) "DP section 6: 24 cm"
    annotation (Placement(transformation(extent={{30,-60},{70,-20}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> section 6 gives both muscles an original length
of 24 cm; Table 2 has 0.23 m for the butyl muscle. The table is used; <code>long</code> is the other.</p>
</html>"));
end ButylPressure;

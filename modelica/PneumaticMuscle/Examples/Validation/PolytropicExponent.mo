within PneumaticMuscle.Examples.Validation;
model PolytropicExponent
  "Pressure, contraction and temperature of the latex muscle for n_g = 1, 1.2, 1.4, DP Figs. 8, 10, 12"
  extends Icons.Validation;
  constant Real n_g[3](each unit="1") = {1, 1.2, 1.4} "Polytropic exponents";
  output Types.GaugePressure p[3] = bench.p "Gauge pressures";
  output Types.Length x[3] = bench.x "Contractions";
  output Types.Temperature T[3] = bench.T "Gas temperatures";
  output Types.GaugePressure p_printed[3] = printed.p "Gauge pressures with the heat transfer coefficient as printed";
  output Types.Length x_printed[3] = printed.x "Contractions with the heat transfer coefficient as printed";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Benches.Isotonic bench[3](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3, muscle(n_g=n_g))
    "Muscles with hanging mass"
    annotation (Placement(transformation(extent={{30,20},{70,60}})));
  Examples.PrintedWallIsotonic printed[3](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3, muscle(n_g=n_g))
    "The same with DP (45) as printed"
    annotation (Placement(transformation(extent={{30,-60},{70,-20}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> find the exponent to matter for the transient and
the steady state, 1.2 and 1.4 close together and 1 apart. With films of air on the wall the steady contraction does not
depend on it; with DP (45) as printed it does, in the order that DP say, but by a stall that they do not report: see
<a href=\"modelica://PneumaticMuscle.Examples.Validation.GasTemperature\">GasTemperature</a>.</p>
</html>"));
end PolytropicExponent;

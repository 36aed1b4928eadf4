within PneumaticMuscle.Examples.Validation;
model BladderFriction "Steady contraction of the butyl muscle for mu_fb = 0.015 and 0.04, DP Figs. 9 and 11"
  extends Icons.Validation;
  constant Real mu_fb[2](each unit="1") = {0.015, 0.04} "Coefficients of friction between fibres and bladder";
  output Types.GaugePressure p[2] = bench.p "Gauge pressures";
  output Types.Length x[2] = bench.x "Contractions";
  output Types.Temperature T[2] = bench.T "Gas temperatures";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Examples.ButylIsotonic bench[2](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3, muscle(mu_fb=mu_fb))
    "Muscles with hanging mass"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> raise mu_fb from 0.015 to 0.04 to move the steady
contraction to the measured one.</p>
</html>"));
end BladderFriction;

within PneumaticMuscle.Examples.Validation;
model ButylSlowRise "The butyl muscle's slow contraction: friction does not explain it, elasticity does, DP Fig. 9"
  extends Icons.Validation;
  output Types.GaugePressure p[3] = {base.p, friction.p, elastic.p} "Gauge pressures";
  output Types.Length x[3] = {base.x, friction.x, elastic.x}
    "Contractions: as published, more friction, elastic bladder";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Examples.ButylIsotonic base(u_in=inlet.y, u_out=outlet.y, p_supply=207e3) "As published"
    annotation (Placement(transformation(extent={{30,45},{70,85}})));
  Examples.ButylIsotonic friction(u_in=inlet.y, u_out=outlet.y, p_supply=207e3, muscle(mu_d=4))
    "Five times the dynamic friction"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Examples.ElasticButyl elastic(u_in=inlet.y, u_out=outlet.y, p_supply=207e3) "With the elasticity of the bladder"
    annotation (Placement(transformation(extent={{30,-85},{70,-45}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>: varying the coefficient of dynamic friction does
little to correct the slope of the contraction; the elastic strain of the bladder is not considered.</p>
</html>"));
end ButylSlowRise;

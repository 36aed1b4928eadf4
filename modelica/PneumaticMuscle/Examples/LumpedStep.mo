within PneumaticMuscle.Examples;
model LumpedStep "The linear model's step from 2.5 to 4.5 bar, AM dynamic step response"
  extends Icons.Example;
  output Types.GaugePressure p = bench.p "Gauge pressure";
  output Types.Length L = bench.L "Length, from that at the operating point";
  output Types.Force F = bench.F "Change of the pull";
  Sources.Step step(before=2.5e5, after=4.5e5, start=0.2, rise=1e-3) "Set pressure of the regulator"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.LumpedLinear bench "Linear model"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(step.y, bench.p_in)
    annotation (Line(points={{-30,0}, {30,0}}, color={0,0,127}));
  annotation (experiment(StopTime=2, Interval=0.002, Tolerance=1e-6), Documentation(info="<html>
<p>The slides sample at 10 Hz and suspect the force response; compare 10 Hz with 80 Hz by the interval of the
output.</p>
</html>"));
end LumpedStep;

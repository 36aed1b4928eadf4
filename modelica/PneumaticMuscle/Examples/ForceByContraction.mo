within PneumaticMuscle.Examples;
model ForceByContraction "Kang's force from full length to full contraction at one pressure, AM Fig. 5"
  extends Icons.Example;
  parameter Types.GaugePressure p(min=0, max=1e6) = 6e5 "Gauge pressure" annotation (Dialog(group="Operation"));
  output Real eps(unit="1") = 0.25*time "Contraction ratio";
  output Types.Force F = bench.F "Pull";
  Benches.StaticForce bench(p=p, eps=eps) "Muscle that is held"
    annotation (Placement(transformation(extent={{-20,-20},{20,20}})));
  annotation (experiment(StopTime=1, Interval=0.005, Tolerance=1e-6), Documentation(info="<html>
<p>Time is only a scale for the contraction ratio: 0.25 at the end.</p>
</html>"));
end ForceByContraction;

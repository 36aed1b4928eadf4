within PneumaticMuscle.Examples;
model RandomWaves "The empirical muscle under a random wave of pressure, DY Figs. 2, 7 and 8"
  extends Icons.Example;
  parameter Types.Mass m(min=5, max=30) = 10 "Load" annotation (Dialog(group="Load"));
  parameter Real frequency(unit="Hz", min=0.5, max=2) = 0.5 "Highest frequency of the wave"
    annotation (Dialog(group="Load"));
  output Types.GaugePressure p = wave.y "Gauge pressure";
  output Real eps(unit="1") = bench.eps "Contraction ratio";
  Sources.RandomWave wave(frequency=frequency, low=0, high=4e5) "Pressure"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.VerticalLoad bench(p=max(0, wave.y), frequency=frequency, load(m=m)) "Muscle with hanging load"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  annotation (experiment(StopTime=20, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Plot eps against p: small loops lie inside the large one, wider at higher frequency and load. Conditions of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> Table 3: 5 to 30 kg, 0.5 to 2 Hz.</p>
</html>"));
end RandomWaves;

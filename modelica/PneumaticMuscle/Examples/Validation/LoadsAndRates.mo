within PneumaticMuscle.Examples.Validation;
model LoadsAndRates "Loops of contraction by pressure at two loads and two frequencies, DY Figs. 2 and 7"
  extends Icons.Validation;
  constant Types.Mass m[4] = {5, 5, 20, 20} "Loads";
  constant Real frequency[4](each unit="Hz") = {0.5, 2, 0.5, 2} "Highest frequencies";
  output Types.GaugePressure p[4] = wave.y "Gauge pressures";
  output Real eps[4](each unit="1") = bench.eps "Contraction ratios";
  Sources.RandomWave wave[4](frequency=frequency, each low=0, each high=4e5) "Pressures"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.VerticalLoad bench[4](p=wave.y, frequency=frequency, load(m=m)) "Muscles with hanging load"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  annotation (experiment(StopTime=20, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The hysteresis grows with load and rate, and a reversal starts a small loop inside the large one.</p>
</html>"));
end LoadsAndRates;

within PneumaticMuscle.Examples.Validation;
model ForceDynamics "Static, net and dynamic force of the empirical muscle at four loads, DY Fig. 5"
  extends Icons.Validation;
  constant Types.Mass m[4] = {5, 10, 20, 30} "Loads";
  output Types.GaugePressure p[4] = wave.y "Gauge pressures";
  output Real eps[4](each unit="1") = bench.eps "Contraction ratios";
  output Types.Force F_s[4] = bench.muscle.braid.F "Static forces";
  output Types.Force F_net[4] = {bench[i].muscle.braid.F - bench[i].excitation.F_load for i in 1:4} "Net forces";
  output Types.Force F_hys[4] = bench.muscle.friction.f "Hysteretic forces";
  output Types.Force F_elastic[4] = bench.muscle.elasticity.f "Elastic forces";
  output Types.Force F_dyn[4] = {m[i]*der(bench[i].load.v) for i in 1:4} "Dynamic forces";
  Sources.RandomWave wave[4](each frequency=0.5, each low=0, each high=4e5) "Pressures"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.VerticalLoad bench[4](p=wave.y, each frequency=0.5, load(m=m)) "Muscles with hanging load"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  annotation (experiment(StopTime=20, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>F_net = F_s - M g and F_dyn = M L eps_ddot, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a>
(13)-(16): F_dyn = F_net - F_elastic - F_hys at every moment. What is left of some hundred newtons to accelerate the
load is a few newtons; DY Fig. 5 plots an F_dyn of the size of F_s, so it is not M L eps_ddot of a muscle that moves
freely, and the text does not say what it is.</p>
</html>"));
end ForceDynamics;

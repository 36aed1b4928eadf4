within PneumaticMuscle.Benches;
model VerticalLoad "The empirical muscle with a hanging load, driven by pressure, DY Fig. 1"
  input Types.GaugePressure p(start=200e3) "Gauge pressure in the muscle";
  output Types.Length x "Contraction";
  output Real eps(unit="1") "Contraction ratio";
  parameter Real frequency(unit="Hz", min=0.01, max=100) = 0.5 "Frequency of the excitation"
    annotation (Dialog(group="Load"));
  inner Components.Ambient ambient "Surroundings";
  inner Components.Excitation excitation(F_load=load.m*Constants.g, frequency=frequency) "Load and frequency of the run";
  Components.Regulator regulator(p_wanted=p) "Pressure regulator";
  Components.EmpiricalMuscle muscle "Muscle";
  Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs";
  Components.Load load(m=10, s_start=muscle.elasticity.x_rest) "Hanging mass, at rest without pressure";
  Sensors.Contraction ruler "Displacement transducer";
equation
  connect(regulator.port, muscle.port);
  connect(muscle.flange_a, load.flange);
  connect(muscle.flange_b, ceiling.flange);
  connect(muscle.flange_a, ruler.flange);
  x = ruler.x;
  eps = x/muscle.L0;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>M L eps_ddot = F_s(P, eps) - F_elastic - F_hys - M g, DY (13)-(16), with x = L eps. Load (5 to 30 kg) and frequency
(0.5 to 2 Hz) are constants of a run. The sign of the speed is rounded (<code>Laws.Frictions.CoulombViscous</code>).
Only the product of <code>muscle.friction.a</code> and <code>muscle.friction.b_f</code> can be found from
measurements: keep one fixed. <code>Examples.PrintedSleeveLoad</code> has DY (12) as printed, <code>Examples.ConstantFrictionLoad</code> friction of
constant coefficients, <code>Examples.LongMuscle</code> the longer of DY's muscles.</p>
</html>"));
end VerticalLoad;

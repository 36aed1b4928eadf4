model SmoothIsotonic "The isotonic bench with currents that are formulas of time, so that no input bends or jumps"
  output PneumaticMuscle.Types.GaugePressure p = bench.p "Gauge pressure in the muscle";
  output PneumaticMuscle.Types.Length x = bench.x "Contraction";
  output PneumaticMuscle.Types.Temperature T = bench.T "Temperature reading in the muscle";
  constant Real omega = 2*3.141592653589793*0.4 "Angular frequency [rad/s]";
  PneumaticMuscle.Benches.Isotonic bench(
    u_in=0.175 + 0.175*sin(omega*time), u_out=0.175 - 0.175*sin(omega*time), p_supply=207e3) "Bench";
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6));
end SmoothIsotonic;

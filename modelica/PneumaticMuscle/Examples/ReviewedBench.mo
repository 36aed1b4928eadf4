within PneumaticMuscle.Examples;
partial model ReviewedBench "A bench for the laws that the papers review"
  input Types.Current u_in(start=0.35) "Current of the inlet valve";
  input Types.Current u_out(start=0) "Current of the exhaust valve";
  input Types.GaugePressure p_supply(start=207e3) "Gauge pressure of the supply";
  output Types.GaugePressure p "Gauge pressure in the muscle";
  output Types.Length x "Contraction";
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p_supply) "Air supply";
  Components.Atmosphere atmosphere "Outlet";
  Components.ReviewedValves valve(u_in=u_in, u_out=u_out) "Inlet and exhaust valve";
  Components.ReviewedMuscle muscle "Muscle";
  Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs";
  Components.Load load(s_start=-load.m*Constants.g/stop.k) "Hanging mass, at rest on the stop";
  Components.Stop stop(L0=muscle.L0) "Full extension";
  Sensors.GaugePressure manometer "Pressure transducer";
  Sensors.Contraction ruler "Displacement transducer";
equation
  connect(supply.port, valve.supply);
  connect(valve.port, muscle.port);
  connect(valve.exhaust, atmosphere.port);
  connect(muscle.port, manometer.port);
  connect(muscle.flange_a, load.flange);
  connect(muscle.flange_b, ceiling.flange);
  connect(muscle.flange_a, stop.flange_a);
  connect(muscle.flange_b, stop.flange_b);
  connect(muscle.flange_a, ruler.flange);
  p = manometer.p;
  x = ruler.x;
  annotation (Documentation(info="<html>
<p><code>Benches.Isotonic</code> with a <code>Components.ReviewedMuscle</code>. The law of force must be chosen:
<code>extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord))</code>.</p>
</html>"));
end ReviewedBench;

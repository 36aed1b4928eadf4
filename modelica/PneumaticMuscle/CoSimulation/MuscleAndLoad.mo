within PneumaticMuscle.CoSimulation;
model MuscleAndLoad "A muscle without its gas that lifts a hanging mass; the pressure comes from outside"
  extends Icons.Bench;
  input Types.GaugePressure p(start=0) "Gauge pressure in the muscle";
  output Types.Length x "Contraction";
  output Types.Volume V "Volume of the gas";
  output Types.VolumeFlowRate V_flow "Rate of the volume";
  output Types.Area A "Area of the wall that exchanges heat with the gas";
  inner Components.Ambient ambient "Surroundings";
  Components.Supply gas(p_gauge=p) "Gas at the pressure that comes from outside";
  Sleeve muscle "Muscle without its gas";
  Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs";
  Components.Load load(s_start=-load.m*Constants.g/stop.k) "Hanging mass, at rest on the stop";
  Components.Stop stop(L0=muscle.L0) "Full extension";
equation
  connect(gas.port, muscle.port);
  connect(muscle.flange_a, load.flange);
  connect(muscle.flange_b, ceiling.flange);
  connect(muscle.flange_a, stop.flange_a);
  connect(muscle.flange_b, stop.flange_b);
  x = load.s;
  V = muscle.braid.V;
  V_flow = der(V);
  A = muscle.A;
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8), Documentation(info="<html>
<p>DP (1), (16)-(17), (68)-(71). Of the outputs none depends at once on the pressure: they follow from position and speed of
the load. Alone, without pressure, the mass rests on the stop.</p>
</html>"));
end MuscleAndLoad;

within PneumaticMuscle.Benches;
model Isotonic "A muscle that lifts a hanging mass, driven by current-driven valves, DP Fig. 2"
  input Types.Current u_in(start=0.35) "Current of the inlet valve";
  input Types.Current u_out(start=0) "Current of the exhaust valve";
  input Types.GaugePressure p_supply(start=207e3) "Gauge pressure of the supply";
  output Types.GaugePressure p "Gauge pressure in the muscle";
  output Types.Length x "Contraction";
  output Types.Temperature T "Temperature reading in the muscle";
  replaceable model Thermometer = Sensors.IdealThermometer constrainedby Interfaces.Thermometer "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line "Line between valves and muscle"
    annotation (choicesAllMatching=true);
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p_supply) "Air supply";
  Components.Atmosphere atmosphere "Outlet";
  Components.ValvePair valve(u_in=u_in, u_out=u_out) "Inlet and exhaust valve";
  Line line "Line between valves and muscle";
  Components.Muscle muscle "Muscle";
  Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs";
  Components.Load load(s_start=-load.m*Constants.g/stop.k) "Hanging mass, at rest on the stop";
  Components.Stop stop(L0=muscle.L0) "Full extension";
  Manometer manometer "Pressure transducer";
  Thermometer thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow) "Thermometer";
  Sensors.Contraction ruler "Displacement transducer";
equation
  connect(supply.port, valve.supply);
  connect(valve.port, line.port_a);
  connect(line.port_b, muscle.port);
  connect(valve.exhaust, atmosphere.port);
  connect(muscle.port, manometer.port);
  connect(muscle.port, thermometer.port);
  connect(muscle.flange_a, load.flange);
  connect(muscle.flange_b, ceiling.flange);
  connect(muscle.flange_a, stop.flange_a);
  connect(muscle.flange_b, stop.flange_b);
  connect(muscle.flange_a, ruler.flange);
  p = manometer.p;
  x = ruler.x;
  T = thermometer.T;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>DP section 3 and Fig. 2, equations DP (17)-(18), (40)-(42), (44)-(49), (59)-(60), (62), (68)-(71): the base model
whose parts are in <code>Components</code>. The mass rests on the stop of the full length at the start. By default it
is filled from 207 kPa at 0.35 A.</p>
</html>"));
end Isotonic;

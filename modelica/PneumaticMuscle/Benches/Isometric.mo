within PneumaticMuscle.Benches;
model Isometric "A muscle whose contraction is imposed, driven by current-driven valves; its pull is measured"
  input Types.Current u_in(start=0.35) "Current of the inlet valve";
  input Types.Current u_out(start=0) "Current of the exhaust valve";
  input Types.GaugePressure p_supply(start=207e3) "Gauge pressure of the supply";
  input Types.Length s(start=0.02) "Imposed contraction";
  output Types.GaugePressure p "Gauge pressure in the muscle";
  output Types.Force F "Pull of the muscle";
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
  Components.ImposedPosition drive(s_wanted=s) "What moves the load end";
  Manometer manometer "Pressure transducer";
  Thermometer thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow) "Thermometer";
  Sensors.Pull loadCell "Load cell";
equation
  connect(supply.port, valve.supply);
  connect(valve.port, line.port_a);
  connect(line.port_b, muscle.port);
  connect(valve.exhaust, atmosphere.port);
  connect(muscle.port, manometer.port);
  connect(muscle.port, thermometer.port);
  connect(muscle.flange_a, loadCell.flange_a);
  connect(loadCell.flange_b, drive.flange);
  connect(muscle.flange_b, ceiling.flange);
  p = manometer.p;
  F = loadCell.F;
  T = thermometer.T;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The muscle of <code>Isotonic</code> between a ceiling and a drive. The imposed contraction reaches the muscle through
a critically damped filter of 5 ms, <code>Components.ImposedPosition</code>, because the speed of the end enters the
pressure, DP (59). It starts from zero contraction whatever the input says. The braid carries no push: a negative pull
does not occur in a sleeve, but the base model allows it beyond full contraction, 3 L^2 &lt; b^2.</p>
</html>"));
end Isometric;

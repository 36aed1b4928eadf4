within PneumaticMuscle.Benches;
model SwitchedMuscle "A muscle of imposed contraction that on-off valves fill from a source whose pressure is measured"
  input Real u_in(start=1, unit="1") "Command of the inlet valve: 0 shut, 1 open";
  input Real u_out(start=0, unit="1") "Command of the exhaust valve: 0 shut, 1 open";
  input Types.GaugePressure p_supply(start=500e3) "Gauge pressure of the source, as it droops";
  input Types.Length s(start=0.02) "Imposed contraction";
  output Types.GaugePressure p "Gauge pressure in the muscle";
  output Types.Temperature T "Temperature reading in the muscle";
  replaceable model Thermometer = Sensors.IdealThermometer constrainedby Interfaces.Thermometer "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line "Line between valves and muscle"
    annotation (choicesAllMatching=true);
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p_supply) "Source";
  Components.Atmosphere atmosphere "Outlet";
  Components.ValvePair valve(u_in=u_open*u_in, u_out=u_open*u_out, C_A=0.2) "Inlet and exhaust valve";
  Line line "Line between valves and muscle";
  Components.Muscle muscle "Muscle";
  Components.Fixed ceiling(s0=muscle.L0) "Where the muscle is fixed";
  Components.ImposedPosition drive(s_wanted=s, tau=1e-3) "What moves the load end";
  Manometer manometer "Pressure transducer";
  Thermometer thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow) "Thermometer";
protected
  constant Types.Current u_open = (1e-5 + 2.61e-7)/1.80e-6 "Current at which DP (62) opens 10 mm2";
equation
  connect(supply.port, valve.supply);
  connect(valve.port, line.port_a);
  connect(line.port_b, muscle.port);
  connect(valve.exhaust, atmosphere.port);
  connect(muscle.port, manometer.port);
  connect(muscle.port, thermometer.port);
  connect(muscle.flange_a, drive.flange);
  connect(muscle.flange_b, ceiling.flange);
  p = manometer.p;
  T = thermometer.T;
  annotation (experiment(StopTime=0.5, Interval=0.001, Tolerance=1e-6), Documentation(info="<html>
<p>As <code>Isometric</code> with valves that are open or shut: a command of 1 opens 10 <code>valve.C_A</code> mm2, so that
<code>valve.C_A</code> is the effective area of the open valve. A finite tank needs no model of its own where the
pressure before the valve is measured: it is the input <code>p_supply</code>, with its droop. The contraction passes a
critically damped filter of 1 ms, <code>Components.ImposedPosition</code>.</p>
</html>"));
end SwitchedMuscle;

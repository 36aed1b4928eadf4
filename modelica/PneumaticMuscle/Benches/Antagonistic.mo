within PneumaticMuscle.Benches;
model Antagonistic "Two muscles that pull a pulley against each other"
  input Types.Current u_in_1(start=0.35) "Current of the first inlet valve";
  input Types.Current u_out_1(start=0) "Current of the first exhaust valve";
  input Types.Current u_in_2(start=0.25) "Current of the second inlet valve";
  input Types.Current u_out_2(start=0.25) "Current of the second exhaust valve";
  input Types.GaugePressure p_supply(start=207e3) "Gauge pressure of the supply";
  output Types.GaugePressure p_1 "Gauge pressure in the first muscle";
  output Types.GaugePressure p_2 "Gauge pressure in the second muscle";
  output Types.Length x "Travel of the rim, towards the first muscle";
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p_supply) "Air supply";
  Components.Atmosphere atmosphere "Outlet";
  Components.ValvePair valve_1(u_in=u_in_1, u_out=u_out_1) "Valves of the first muscle";
  Components.ValvePair valve_2(u_in=u_in_2, u_out=u_out_2) "Valves of the second muscle";
  Components.Muscle muscle_1 "First muscle";
  Components.Muscle muscle_2 "Second muscle";
  Components.Fixed frame_1(s0=muscle_1.L0) "Where the first muscle is fixed";
  Components.Fixed frame_2(s0=muscle_2.L0) "Where the second muscle is fixed";
  Components.Stop stop_1(L0=muscle_1.L0) "Full extension of the first muscle";
  Components.Stop stop_2(L0=muscle_2.L0) "Full extension of the second muscle";
  Components.Pulley pulley "Pulley";
  Sensors.GaugePressure manometer_1 "Pressure transducer";
  Sensors.GaugePressure manometer_2 "Pressure transducer";
equation
  connect(supply.port, valve_1.supply);
  connect(supply.port, valve_2.supply);
  connect(valve_1.port, muscle_1.port);
  connect(valve_2.port, muscle_2.port);
  connect(valve_1.exhaust, atmosphere.port);
  connect(valve_2.exhaust, atmosphere.port);
  connect(muscle_1.port, manometer_1.port);
  connect(muscle_2.port, manometer_2.port);
  connect(muscle_1.flange_a, pulley.flange_1);
  connect(muscle_2.flange_a, pulley.flange_2);
  connect(muscle_1.flange_b, frame_1.flange);
  connect(muscle_2.flange_b, frame_2.flange);
  connect(muscle_1.flange_a, stop_1.flange_a);
  connect(muscle_1.flange_b, stop_1.flange_b);
  connect(muscle_2.flange_a, stop_2.flange_a);
  connect(muscle_2.flange_b, stop_2.flange_b);
  p_1 = manometer_1.p;
  p_2 = manometer_2.p;
  x = pulley.r*pulley.phi;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Two muscles of DP on a pulley, each with its valves; both are contracted by <code>pulley.x_0</code> in the middle
position, so that each has room to extend. They fill alike in volume and pressure until the one that is filled faster turns
the pulley; the angle is x/<code>pulley.r</code>.</p>
</html>"));
end Antagonistic;

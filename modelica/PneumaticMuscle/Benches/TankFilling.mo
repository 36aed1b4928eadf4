within PneumaticMuscle.Benches;
model TankFilling "A tank that is filled and emptied through current-driven valves, DP section 4.4"
  input Types.Current u_in(start=0.35) "Current of the inlet valve";
  input Types.Current u_out(start=0) "Current of the exhaust valve";
  input Types.GaugePressure p_supply(start=207e3) "Gauge pressure of the supply";
  output Types.GaugePressure p "Gauge pressure in the tank";
  output Types.Temperature T(displayUnit="degC") "Temperature reading in the tank";
  replaceable model Thermometer = Sensors.IdealThermometer constrainedby Interfaces.Thermometer "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line "Line between valves and tank"
    annotation (choicesAllMatching=true);
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p_supply) "Air supply";
  Components.Atmosphere atmosphere "Outlet";
  Components.ValvePair valve(u_in=u_in, u_out=u_out) "Inlet and exhaust valve";
  Line line "Line between valves and tank";
  Components.Tank tank "Tank";
  Manometer manometer "Pressure transducer";
  Thermometer thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow) "Thermometer";
equation
  connect(supply.port, valve.supply);
  connect(valve.port, line.port_a);
  connect(line.port_b, tank.port);
  connect(valve.exhaust, atmosphere.port);
  connect(tank.port, manometer.port);
  connect(tank.port, thermometer.port);
  p = manometer.p;
  T = thermometer.T;
  annotation (experiment(StopTime=60, Interval=0.06, Tolerance=1e-6), Documentation(info="<html>
<p>DP (60), (62)-(66), Figs. 4 and 5: eight volumes, two supplies, 0.35 A. The library's tests hold the times against
quadrature.</p>
</html>"));
end TankFilling;

within PneumaticMuscle.Benches;
model VesselOrifice "A vessel that empties or fills through a plain orifice"
  output Types.GaugePressure p "Gauge pressure in the vessel";
  output Types.Temperature T "Temperature reading in the vessel";
  parameter Types.GaugePressure p_outside(min=-1.01e5, max=1e8) = 0 "Gauge pressure outside"
    annotation (Dialog(group="Surroundings"));
  replaceable model Thermometer = Sensors.IdealThermometer constrainedby Interfaces.Thermometer "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  inner Components.Ambient ambient "Surroundings";
  Components.Tank tank(V=16.2e-3, p_start=6.9e5, startIsReference=true) "Vessel";
  Components.PlainOrifice orifice "Hole";
  Components.Atmosphere atmosphere(p_gauge=p_outside) "Outside";
  Manometer manometer "Pressure transducer";
  Thermometer thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow) "Thermometer";
equation
  connect(tank.port, orifice.port_a);
  connect(orifice.port_b, atmosphere.port);
  connect(tank.port, manometer.port);
  connect(tank.port, thermometer.port);
  p = manometer.p;
  T = thermometer.T;
  annotation (experiment(StopTime=60, Interval=0.06, Tolerance=1e-6), Documentation(info="<html>
<p>The polytropic law starts from the state of the vessel: T = T_start (p/p_start)^((n - 1)/n), absolute
pressures.</p>
</html>"));
end VesselOrifice;

within PneumaticMuscle.Benches;
model ClosedVessel "A vessel under pressure with everything shut"
  output Types.GaugePressure p "Gauge pressure in the vessel";
  output Types.Temperature T "Temperature reading in the vessel";
  replaceable model Thermometer = Sensors.IdealThermometer constrainedby Interfaces.Thermometer "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  inner Components.Ambient ambient "Surroundings";
  Components.Tank tank(V=1e-4, p_start=7e5, startIsReference=true) "Vessel";
  Manometer manometer "Pressure transducer";
  Thermometer thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow) "Thermometer";
equation
  connect(tank.port, manometer.port);
  connect(tank.port, thermometer.port);
  p = manometer.p;
  T = thermometer.T;
  annotation (experiment(StopTime=150, Interval=0.15, Tolerance=1e-6), Documentation(info="<html>
<p>The test of tightness: fill, shut, and watch the pressure. As it stands nothing changes; what does is an effect. A
leak is found in proportion to the volume: without <code>tank.V</code> only the ratio is known.</p>
</html>"));
end ClosedVessel;

model Reservoir "A user's own bench: a bottle that empties into the room"
  import PneumaticMuscle.Pneumatics.Components;
  output PneumaticMuscle.Types.GaugePressure pressure "Reading of the gauge";
  output PneumaticMuscle.Types.Temperature temperature "Reading of the thermometer";
  replaceable model Thermometer = PneumaticMuscle.Instruments.Sensors.IdealThermometer
    constrainedby PneumaticMuscle.Interfaces.Thermometer;
  inner PneumaticMuscle.Ambient ambient;
  Components.Tank bottle(V=16.2e-3, p_start=690e3, startIsReference=true);
  Components.PlainOrifice hole(d=2.71e-3, C_d=0.7);
  Components.Atmosphere room;
  Thermometer thermometer(T_start=bottle.T_start);
equation
  connect(bottle.port, hole.port_a);
  connect(hole.port_b, room.port);
  connect(bottle.port, thermometer.port);
  pressure = bottle.port.p - ambient.p;
  temperature = thermometer.T;
  annotation (experiment(StopTime=60, Interval=0.2));
end Reservoir;

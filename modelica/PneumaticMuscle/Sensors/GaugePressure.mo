within PneumaticMuscle.Sensors;
model GaugePressure "A gauge pressure transducer"
  Interfaces.GasPort port "Pressure tap";
  Types.GaugePressure p "Reading";
  outer Components.Ambient ambient "Surroundings";
equation
  p = port.p - ambient.p;
  port.m_flow = 0;
  port.H_flow = 0;
end GaugePressure;

within PneumaticMuscle.Interfaces;
partial model Manometer "What the instrument makes of the gas pressure"
  GasPort port "Pressure tap";
  Types.GaugePressure p "Reading";
  outer Components.Ambient ambient "Surroundings";
equation
  port.m_flow = 0;
  port.H_flow = 0;
end Manometer;

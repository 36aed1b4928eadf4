model BurstLeak "A crack that opens with pressure"
  extends PneumaticMuscle.Interfaces.GasPortEffect(final family="burst_leak");
  parameter Real K(unit="kg/(s.Pa2)", min=0, max=1e-13, nominal=1e-15) = 1e-15 "Flow per gauge pressure squared";
equation
  port.m_flow = K*(port.p - ambient.p)*max(0, port.p - ambient.p);
  port.H_flow = port.m_flow*PneumaticMuscle.Constants.cp
    *PneumaticMuscle.Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
end BurstLeak;

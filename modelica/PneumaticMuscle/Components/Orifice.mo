within PneumaticMuscle.Components;
model Orifice "An orifice with isentropic flow whose effective area is given from outside"
  extends Interfaces.TwoGasPorts;
  input Types.Area A "Effective area";
equation
  m_flow = Functions.isentropicFlow(port_a.p, port_b.p, T_up, A);
end Orifice;

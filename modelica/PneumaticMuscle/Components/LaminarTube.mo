within PneumaticMuscle.Components;
model LaminarTube "A tube with isothermal laminar flow"
  extends Interfaces.TwoGasPorts;
  parameter Real G(unit="kg/(s.Pa)") "Conductance at ambient pressure";
  outer Ambient ambient "Surroundings";
equation
  m_flow = G*(port_a.p^2 - port_b.p^2)/(2*ambient.p);
end LaminarTube;

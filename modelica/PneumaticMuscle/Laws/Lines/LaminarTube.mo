within PneumaticMuscle.Laws.Lines;
model LaminarTube "A tube with isothermal laminar flow"
  extends Interfaces.TwoGasPorts;
  extends Icons.Line;
  parameter Real G(unit="kg/(s.Pa)") "Conductance at ambient pressure" annotation (Dialog(group="Flow"));
  outer Ambient ambient "Surroundings";
equation
  m_flow = G*(port_a.p^2 - port_b.p^2)/(2*ambient.p);
  annotation (Documentation(info="<html>
<p>m_flow = G (p_a^2 - p_b^2)/(2 p_atm): isothermal laminar flow of an ideal gas, after Hagen and Poiseuille.</p>
</html>"));
end LaminarTube;

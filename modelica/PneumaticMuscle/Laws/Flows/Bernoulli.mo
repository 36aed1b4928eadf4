within PneumaticMuscle.Laws.Flows;
model Bernoulli "Incompressible flow, DP (10)"
  extends Flow;
  parameter Real C_q(unit="1", min=0.1, max=3) = 1 "Flow coefficient" annotation (Dialog(group="Law"));
protected
  constant Types.Pressure dp_laminar = 20 "Pressure drop below which the flow is laminar";
  Types.Pressure dp = port_a.p - port_b.p "Pressure drop";
  Real rho(unit="kg/m3") = max(max(port_a.p, port_b.p), 1.0)/(Constants.R*T_up) "Density upstream";
equation
  m_flow = C_q*A*sqrt(2*rho)*dp/(dp^2 + dp_laminar^2)^0.25;
  annotation (Documentation(info="<html>
<p>Q = f_v C_q A_v sqrt(2/rho) sqrt(|P_in - P_out|), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(10), with f_v for the sign of the drop; the mass flow rate is rho Q with the density upstream. Laminar below 20 Pa. It
does not choke: DP remark that it holds at low velocities only, where the density hardly changes.</p>
</html>"));
end Bernoulli;

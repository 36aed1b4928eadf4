within PneumaticMuscle.Laws.Flows;
model Isentropic "Compressible flow, choked or not, DP (40)-(42)"
  extends Flow;
equation
  m_flow = Functions.isentropicFlow(port_a.p, port_b.p, T_up, A);
  annotation (Documentation(info="<html>
<p>m_flow = K p_up A N/sqrt(T_up), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (41); see
<a href=\"modelica://PneumaticMuscle.Functions.isentropicFlow\">Functions.isentropicFlow</a>. The base model's own
law.</p>
</html>"));
end Isentropic;

within PneumaticMuscle.Pneumatics.Components;
model Orifice "An orifice with isentropic flow whose effective area is given from outside"
  extends Interfaces.TwoGasPorts;
  extends Icons.Orifice;
  input Types.Area A "Effective area";
equation
  m_flow = Functions.isentropicFlow(port_a.p, port_b.p, T_up, A);
  annotation (Documentation(info="<html>
<p>m_flow = K p_up A N/sqrt(T_up), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42),
<a href=\"modelica://PneumaticMuscle.Functions.isentropicFlow\">Functions.isentropicFlow</a>.</p>
</html>"));
end Orifice;

within PneumaticMuscle.Interfaces;
partial model TwoGasPorts "A resistance between two gas ports: no storage, upstream enthalpy"
  extends Icons.Named;
  GasPort port_a "Side from which a positive flow comes"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  GasPort port_b "Side to which a positive flow goes"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Types.MassFlowRate m_flow "Mass flow rate from port_a to port_b";
protected
  Types.Temperature T_up = Functions.upstreamTemperature(port_a.p, port_b.p, port_a.T, port_b.T)
    "Temperature of the gas on the side it comes from";
equation
  port_a.m_flow = m_flow;
  port_b.m_flow = -m_flow;
  port_a.H_flow = m_flow*Constants.cp*T_up;
  port_b.H_flow = -m_flow*Constants.cp*T_up;
  annotation (Documentation(info="<html>
<p>No storage: what flows in flows out, with the enthalpy c_p T of the side it comes from,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (51). Left to the extending class: the equation of
m_flow.</p>
</html>"));
end TwoGasPorts;

within PneumaticMuscle.Laws.Lines;
model CurvedTube "A tube whose flow is a curved power of the drop of the square of pressure, another each way"
  extends Interfaces.TwoGasPorts;
  extends Icons.Line;
  parameter Real G(unit="kg/(s.Pa)") "Conductance at the reference drop, at ambient pressure"
    annotation (Dialog(group="Flow"));
  parameter Real a(unit="1") "Exponent of the conductance at the reference drop" annotation (Dialog(group="Flow"));
  parameter Real b(unit="1") "Half of what the exponent gains where the drop grows by e"
    annotation (Dialog(group="Flow"));
  parameter Real c(unit="1") "Exponent of the pressure upstream" annotation (Dialog(group="Flow"));
  parameter Real side(unit="1") "What the logarithm of the conductance gains from port_a to port_b and loses back"
    annotation (Dialog(group="Flow"));
  outer Ambient ambient "Surroundings";
protected
  constant Types.Pressure p_reference = 1e5 "Drop of pressure at ambient pressure to which G refers";
  constant Real width(unit="1") = 3e-3 "Drop by the reference below which the law is linear";
  Real u(unit="1") = (port_a.p^2 - port_b.p^2)/(2*ambient.p*p_reference) "Drop by the reference";
equation
  m_flow = G*p_reference*Functions.curvedPower(u, a, b, width)
    *exp(c*log(max(max(port_a.p, port_b.p), 1.0)/ambient.p) + side*u/sqrt(u^2 + width^2));
  annotation (Documentation(info="<html>
<p>m_flow = G p_ref u |u|^(a + b ln|u|) (p_up/p_atm)^c exp(side sgn u), u = (p_a^2 - p_b^2)/(2 p_atm p_ref), p_ref = 100
kPa, <a href=\"modelica://PneumaticMuscle.Functions.curvedPower\">Functions.curvedPower</a>. a = b = c = side = 0 is
<a href=\"modelica://PneumaticMuscle.Laws.Lines.LaminarTube\">LaminarTube</a>.</p>
</html>"));
end CurvedTube;

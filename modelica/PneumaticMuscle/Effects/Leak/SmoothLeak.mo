within PneumaticMuscle.Effects.Leak;
partial model SmoothLeak "Gas escapes by a smooth law of the gauge pressure, times what further acts on the conductance"
  extends FamilyMember(final absent="G=0");
  parameter Real G(unit="kg/(s.Pa)", min=0, max=1e-9, nominal=1e-11) = 1e-11 "Conductance at 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-1, max=2.5, nominal=0.5) = 0 "Exponent of the conductance at 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0
    "Quadratic coefficient of the exponent, by the logarithm of the pressure"
    annotation (Dialog(group="Effect"));
  parameter Real g(unit="1", min=-4, max=2, nominal=0.3) = 0
    "Increase of the logarithm of the conductance per 100 kPa beyond 100 kPa"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which the law equals G p";
  Real q(unit="1") = (port.p - ambient.p)/p_reference "Gauge pressure by the reference";
  Real over(unit="1") "What drives the gas out, by the reference";
  Real further(unit="1") "Additional term of the logarithm of the conductance";
equation
  port.m_flow = G*p_reference*Functions.curvedPower(over, a, b, 0.01)*exp(g*(q - 1) + further);
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  annotation (Documentation(info="<html>
<p>m_flow = G 100 kPa r |r|^(a + b ln|r|) exp(g (q - 1) + further), q = p_gauge/100 kPa,
<a href=\"modelica://PneumaticMuscle.Functions.curvedPower\">Functions.curvedPower</a> of r = <code>over</code>: gas
flows out where the pressure is above the ambient one, whatever a, b and g are. Source: the power law m = C p^n of leaks
(Hagen and Poiseuille n = 1, orifice n = 1/2, seals that open more), with one more term in the logarithm of pressure,
and a gap whose logarithm goes with the pressure that presses a lip or a ball shut or open.</p>
<p>Left to the extending class: <code>over</code> and <code>further</code>.</p>
</html>"));
end SmoothLeak;

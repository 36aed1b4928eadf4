within PneumaticMuscle.Effects.Leak;
model FlexibleLeak "Gas escapes by any smooth law of the gauge pressure"
  extends FamilyMember(final absent="G=0");
  parameter Real G(unit="kg/(s.Pa)", min=0, max=1e-9, nominal=1e-11) = 1e-11 "Conductance at 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-1, max=2.5, nominal=0.5) = 0 "Exponent of the conductance at 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0
    "Half of what the exponent gains where the pressure grows by e"
    annotation (Dialog(group="Effect"));
  parameter Real g(unit="1", min=-4, max=2, nominal=0.3) = 0
    "What the logarithm of the conductance gains per 100 kPa beyond 100 kPa"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which the law equals G p";
  Real u(unit="1") = (port.p - ambient.p)/p_reference "Gauge pressure by the reference";
equation
  port.m_flow = G*p_reference*Functions.curvedPower(u, a, b, 0.01)*exp(g*(u - 1));
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G p_gauge |u|^(a + b ln|u|) exp(g (u - 1)), u = p_gauge/100 kPa,
<a href=\"modelica://PneumaticMuscle.Functions.curvedPower\">Functions.curvedPower</a>: gas flows out where the pressure
is above the ambient one, whatever a, b and g are. Source: the power law m = C p^n of leaks (Hagen and Poiseuille n = 1,
orifice n = 1/2, seals that open more), with one more term in the logarithm of pressure, and a gap whose logarithm goes
with the pressure that presses a lip or a ball shut or open. Up to 250 kPa it is, with g = 0, within 2 %
of laminar, orifice, square-root, square, cubic and compressible laminar leaks and of their sums, and within 3 to 9 % of
one that opens at a threshold of 50 to 100 kPa. Typical G 1e-12 to 1e-10 kg/(s.Pa), a -0.5 to 1, b 0, g -1 to 0.5.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.OrificeLeak\">OrificeLeak</a>, by another law of
pressure.</p>
</html>"));
end FlexibleLeak;

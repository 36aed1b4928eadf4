within PneumaticMuscle.Functions;
function curvedFlow "Flow by a curved power of the drop of the square of pressure, another each way"
  extends Icons.Function;
  input Types.AbsolutePressure p_a "Pressure on side a";
  input Types.AbsolutePressure p_b "Pressure on side b";
  input Types.AbsolutePressure p_ambient "Ambient pressure";
  input Real G(unit="kg/(s.Pa)") "Conductance at the reference drop, at ambient pressure";
  input Real a "Exponent of the conductance at the reference drop";
  input Real b "Quadratic coefficient of the exponent, by the logarithm of the drop";
  input Real c "Exponent of the pressure upstream";
  input Real asymmetry "Asymmetry of the logarithm of the conductance between both directions";
  output Types.MassFlowRate m_flow "Flow from a to b";
protected
  constant Types.Pressure p_reference = 1e5 "Drop of pressure at ambient pressure to which G refers";
  constant Real width = 3e-3 "Drop by the reference below which the law is linear";
  Real u "Drop by the reference";
algorithm
  u := (p_a^2 - p_b^2)/(2*p_ambient*p_reference);
  m_flow := G*p_reference*curvedPower(u, a, b, width)
    *exp(c*log(max(max(p_a, p_b), 1.0)/p_ambient) + asymmetry*u/sqrt(u^2 + width^2));
  annotation (Documentation(info="<html>
<p>m_flow = G p_ref u |u|^(a + b ln|u|) (p_up/p_atm)^c exp(side sgn u), u = (p_a^2 - p_b^2)/(2 p_atm p_ref), p_ref = 100
kPa, <a href=\"modelica://PneumaticMuscle.Functions.curvedPower\">Functions.curvedPower</a>. Source: the power laws of
tubes, see <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.GeneralLine\">GeneralLine</a>. a = b = c = side = 0
is laminar.</p>
</html>"));
end curvedFlow;

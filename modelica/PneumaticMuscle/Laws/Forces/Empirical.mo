within PneumaticMuscle.Laws.Forces;
model Empirical "Gaylord's force with factors on strain and force, DY (1)-(7)"
  extends Interfaces.Cylinder;
  parameter Real k(unit="1", min=0.5, max=2) = 1 "Factor on the strain, DY (2)" annotation (Dialog(group="Law"));
  parameter Real c_1(unit="1", min=0, max=10) = 3 "Excess of the factor on the strain at no pressure"
    annotation (Dialog(group="Law"));
  parameter Real c_2(unit="1/Pa", min=-1e-4, max=0, nominal=1e-6) = -2e-6 "Its exponent on pressure"
    annotation (Dialog(group="Law"));
  parameter Real c_3(unit="1", min=-2, max=5) = 0.3 "Part of the factor on the force that strain takes away"
    annotation (Dialog(group="Law"));
  parameter Real c_4(unit="1", min=-100, max=0, nominal=10) = -15 "Its exponent on strain"
    annotation (Dialog(group="Law"));
  parameter Real c_5(unit="1", min=0.1, max=3) = 0.95 "Part of the factor on the force that stays"
    annotation (Dialog(group="Law"));
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Real eps(unit="1") = (L0 - L)/L0 "Contraction ratio";
  Real q(unit="1") = 1 + c_1*exp(c_2*p_gauge) "Shape irregularity";
  Real mu(unit="1") = c_3*exp(c_4*eps) + c_5 "Slenderness";
protected
  Types.Length L_e = L0*(1 - k*q*eps) "Length that counts in the force";
equation
  F = mu*p_gauge*(3*L_e^2 - b^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>F_s = mu(eps) pi D0^2 P/4 (3 (1 - k q(P) eps)^2/tan(alpha_0)^2 - 1/sin(alpha_0)^2),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (1), (3), (5), with q(P) = 1 + c_1 exp(c_2 P), DY
(6), and mu(eps) = c_3 exp(c_4 eps) + c_5, DY (7). With tan(alpha_0) = n pi D0/L0 this is mu P (3 L_e^2 - b^2)/(4 pi
n^2) at the length L_e = L0 (1 - k q eps). DY (4) has a constant in the place of the 1 of (6); a constant other than 1
is the k here.</p>
<p>Defaults: q of the slides (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force
equation 1), mu chosen for illustration: DY tabulate no values. k, c_5 and the diameter are easily confused in a fit;
keep two of them fixed.</p>
</html>"));
end Empirical;

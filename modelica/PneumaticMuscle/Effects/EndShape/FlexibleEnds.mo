within PneumaticMuscle.Effects.EndShape;
model FlexibleEnds "The pull differs from the cylinder's by any smooth law of contraction that fades with pressure"
  extends Interfaces.Cylinder;
  extends FamilyMember(final absent="a_0=0, a_1=0, a_2=0");
  parameter Real a_0(unit="1", min=-0.5, max=0.5, nominal=0.1) = 0 "Excess of the pull at full length"
    annotation (Dialog(group="Effect"));
  parameter Real a_1(unit="1", min=-2, max=0.3, nominal=0.1) = -0.05 "Linear coefficient of the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real a_2(unit="1", min=-1, max=0.5, nominal=0.1) = 0 "Quadratic coefficient of the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real s(unit="1", min=-0.1, max=3, nominal=0.3) = 0.5 "Decay rate of the excess, per 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=-0.03, max=0.3, nominal=0.1) = 0 "Quadratic coefficient of the decay rate, per 100 kPa"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure to which s and r refer";
  constant Real e_reference(unit="1") = 0.25 "Strain at which a_1 and a_2 count fully";
  constant Real e_end(unit="1") = 1.7 "Contraction beyond all that a muscle reaches, where the excess ends";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Real q(unit="1") = p_gauge/p_reference "Pressure by its reference";
  Real e(unit="1") = (1 - L/L0)/e_reference "Contraction";
  Real excess(unit="1") = (a_0 + e*(a_1 + a_2*e))*exp(-(s + r*q)*q)/(1 + (e/e_end)^24) "By the pull at full length";
equation
  F = p_gauge*(3*L^2 - b^2 + excess*(3*L0^2 - b^2))/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>F = p_gauge (A(L) + A(L0) (a_0 + a_1 e + a_2 e^2) exp(-s q - r q^2)), A(L) = (3 L^2 - b^2)/(4 pi n^2), q =
p_gauge/100 kPa, e = strain/0.25; beyond 40 % of strain the excess ends, so that no coefficients make the muscle pull
itself together. Source: A(L) itself is a parabola, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(1), and so is what the factor on the strain of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Tondu,
Boitier and Lopez 1994</a> makes of it, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (1)-(2); the
exponential is that of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Kang and others 2009</a>, DY
(3)-(4), with one more term. It holds Tondu's law exactly, Kang's within 1 %, a factor of any parabola in the strain on
the whole pull within 2 %, ends of fixed size within 2 %, and ends that close in proportion to the pressure within 1 %;
what grows or falls with the inverse of pressure within 4 to 7 %; a factor that dies away within a tenth of the length
(<a href=\"modelica://PneumaticMuscle.Effects.EndShape.KerscherEnds\">KerscherEnds</a>) within 10 %. The volume keeps
the cylinder's law. Typical -0.3 to 0.3 for the a, s 0 to 2, r -0.05 to 0.1.</p>
<p>Fingerprint: pull and length at rest are wrong in proportion to the pressure, by a share that depends on the
contraction alone (s = 0) or is largest at low pressure.</p>
</html>"));
end FlexibleEnds;

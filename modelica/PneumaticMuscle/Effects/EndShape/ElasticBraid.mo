within PneumaticMuscle.Effects.EndShape;
model ElasticBraid "The fibres of the sleeve stretch under the tension that the pressure gives them"
  extends Interfaces.Braid;
  extends FamilyMember(final absent="e_f=0");
  parameter Real e_f(unit="1", min=0, max=0.2, nominal=0.01) = 0.01 "Strain of the fibres where all of them carry 1 kN"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Force T_reference = 1e3 "Tension to which the strain refers";
  constant Real u_end(unit="1") = 0.6 "Share beyond all that fibres bear, where the stretch ends";
  constant Types.Pressure p_smooth = 100 "Pressure over which fibres become slack";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Types.Force T_0 = Functions.slackMax(p_gauge, p_smooth)*L*b/(2*Constants.pi*turns^2)
    "Tension of all fibres together at their length without tension";
  Real u(unit="1") = e_f*T_0/T_reference "Strain of the fibres by that, were the geometry to stay";
  Types.Length b_f = b/(1 - u/(1 + (u/u_end)^8)^(1/8)) "Length of a fibre under tension";
equation
  D = sqrt(max(b_f^2 - L^2, 1e-8))/(turns*Constants.pi);
  V = L*(b_f^2 - L^2)/(4*Constants.pi*turns^2);
  F = p_gauge*(3*L^2 - b_f^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>A cylinder whose fibres have the length b_f = b (1 + e_f T/(1 kN)), Hooke's law, with the tension T of all fibres
together. What the pressure presses apart across the diameter, p D L, crosses every fibre at two windings: p D L = 2 n T
sin(theta), where D = b_f sin(theta)/(n pi), so that T = p L b_f/(2 pi n^2). Both together give b_f = b/(1 - e_f p L
b/(2 pi n^2)/(1 kN)), and the pull T cos(theta) - p pi D^2/4 is that of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1) with b_f. The number of windings stays. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Chambers and Wereley 2022</a> measured that an inelastic
braid underestimates the diameter by up to 30 % and overestimates the pull by up to 70 %; the balance of forces is that
of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Schulte 1961</a>, which Gaylord's force, DP (1), follows
from too. e_f is one over the tensile stiffness of all fibres together: typical 0.001 to 0.005 for stiff yarns, 0.01 and
more for soft or crimped ones. Strains beyond 100 % do not occur: there the law is bent. Below ambient pressure fibres
are slack.</p>
<p>Fingerprint: the pull falls short in proportion to the square of the pressure, at short length to nothing: the muscle
stops earlier the higher the pressure is; it also takes more gas. A factor on the strain
(<a href=\"modelica://PneumaticMuscle.Effects.EndShape.TonduEnds\">TonduEnds</a>) is the same at all pressures.</p>
</html>"));
end ElasticBraid;

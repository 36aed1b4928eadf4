within PneumaticMuscle.Effects.EndShape;
model KangEnds "The ends contract less than the middle, the more so the lower the pressure"
  extends Interfaces.Cylinder;
  extends FamilyMember(final absent="c_1=0");
  parameter Real c_1(unit="1", min=0, max=5, nominal=0.1) = 0.2 "Excess of the factor on the strain at no pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.GaugePressure p_0(min=2e4, max=1e6, nominal=1e5) = 1e5 "Gauge pressure of decay to 1/e"
    annotation (Dialog(group="Effect"));
protected
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Types.Length L_e = L0 - (1 + c_1*exp(-p_gauge/p_0))*(L0 - L) "Length that counts in the force";
equation
  F = p_gauge*(3*L_e^2 - b^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.EndShape.TonduEnds\">TonduEnds</a> with q(p) = 1 + c_1 exp(c_2 p) in
the place of k, c_2 = -1/p_0. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Kang and others
2009</a>, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (4),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (3)-(4) and (6). Typical c_1 0.1 to 3, p_0 50 to 500
kPa (c_2 = -2e-6 1/Pa is 500 kPa). The volume keeps the cylinder's law.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.EndShape.TonduEnds\">TonduEnds</a>, large at low
pressure and gone at high pressure.</p>
</html>"));
end KangEnds;

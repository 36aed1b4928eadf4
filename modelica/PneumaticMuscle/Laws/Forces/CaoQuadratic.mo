within PneumaticMuscle.Laws.Forces;
model CaoQuadratic "Polynomial in contraction and speed, coefficients linear in pressure, DP (7)"
  extends Interfaces.Cylinder;
  parameter Types.Force F_0(min=-1e3, max=1e3) = 0 "F at no pressure" annotation (Dialog(group="Law"));
  parameter Types.Area F_1(min=0, max=0.1, nominal=1e-3) = 6e-4 "F per gauge pressure" annotation (Dialog(group="Law"));
  parameter Types.TranslationalDamping B1_0(min=-1e4, max=1e4) = -40 "B1 at no pressure"
    annotation (Dialog(group="Law"));
  parameter Real B1_1(unit="N.s/(m.Pa)", min=-0.1, max=0.1, nominal=1e-4) = -1e-4 "B1 per gauge pressure"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalStiffness K1_0(min=-1e5, max=1e5) = -500 "K1 at no pressure"
    annotation (Dialog(group="Law"));
  parameter Types.Length K1_1(min=-1, max=1, nominal=1e-3) = -7e-3 "K1 per gauge pressure"
    annotation (Dialog(group="Law"));
  parameter Real K2_0(unit="N/m2", min=-1e6, max=1e6, nominal=1e3) = 0 "K2 at no pressure"
    annotation (Dialog(group="Law"));
  parameter Real K2_1(unit="1", min=-10, max=10) = 0.01 "K2 per gauge pressure" annotation (Dialog(group="Law"));
  parameter Real B2_0(unit="N.s/m2", min=-1e5, max=1e5, nominal=1e2) = -100 "B2 at no pressure"
    annotation (Dialog(group="Law"));
  parameter Real B2_1(unit="s", min=-1, max=1, nominal=1e-3) = 0 "B2 per gauge pressure"
    annotation (Dialog(group="Law"));
  Types.Length x = L0 - L "Contraction";
  Types.Velocity v = der(x) "Speed of contraction";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
equation
  F = F_0 + F_1*p_gauge + (B1_0 + B1_1*p_gauge)*v + (K1_0 + K1_1*p_gauge)*x + (K2_0 + K2_1*p_gauge)*x^2
    + (B2_0 + B2_1*p_gauge)*x*v;
  annotation (Documentation(info="<html>
<p>F(P) + B1(P) v + K1(P) x + K2(P) x^2 + B2(P) x v = load + M x_ddot,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (7), reference 20 there. With the signs as printed a
restoring spring and a damper have negative coefficients. No coefficients are given; the defaults are of the size of the
latex muscle of DP Table 1 and are there to be fitted.</p>
</html>"));
end CaoQuadratic;

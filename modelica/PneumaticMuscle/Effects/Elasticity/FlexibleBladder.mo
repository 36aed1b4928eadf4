within PneumaticMuscle.Effects.Elasticity;
model FlexibleBladder "The bladder is a spring of any smooth law"
  extends FamilyMember(final absent="k=0");
  parameter Types.TranslationalStiffness k(min=0, max=2e4, nominal=200) = 200
    "Force by contraction at the reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-0.8, max=2, nominal=0.3) = 0 "Its relative growth per reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.15, max=0.5, nominal=0.1) = 0 "Quadratic coefficient of the growth"
    annotation (Dialog(group="Effect"));
protected
  Real s(unit="1") = 8*x/L0 - 1 "Contraction beyond the reference, an eighth of the length, by the reference";
equation
  f = k*x*exp(s*(a + b*s));
  annotation (defaultComponentName="bladder", Documentation(info="<html>
<p>f = k x exp(a s + b s^2), s = 8 x/L0 - 1: the force always pulls back, whatever a and b are. Source: the
exponential law of soft tissue, whose stiffness by force is a constant
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Fung 1967</a>), with one more term in the exponent. Over a
contraction of 0 to 29 % it is within 2 % of linear, polynomial, exponential, logarithmic, square root, arctan, tanh,
sine and Mooney-Rivlin springs, and within 5 to 12 % of a slack that ends with a corner, or of a stop. Typical k 50 to
2000 N/m, a -0.6 to 1, b 0 to 0.2.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Elasticity.LinearBladder\">LinearBladder</a>; the error
grows faster (a above 0) or slower (below) than the contraction.</p>
</html>"));
end FlexibleBladder;

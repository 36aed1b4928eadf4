within PneumaticMuscle.Effects.Elasticity;
model GeneralBladder
  "The bladder is a spring of any smooth law of contraction, up to the fourth power in its exponent, "
  + "and of pressure, and a stiff wall"
  extends FamilyMember(final general=true, final absent="k=0, p_0=0, p_w=0");
  parameter Types.TranslationalStiffness k(min=0, max=2e4, nominal=200) = 200
    "Force by contraction at the reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-3, max=6, nominal=0.3) = 0 "Its relative growth per reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-4, max=3, nominal=0.1) = 0 "Coefficient of the second power"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="1", min=-2, max=2, nominal=0.1) = 0 "Coefficient of the third power"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="1", min=-1, max=1, nominal=0.1) = 0 "Coefficient of the fourth power"
    annotation (Dialog(group="Effect"));
  parameter Real h(unit="1", min=-2, max=2, nominal=0.3) = 0 "Exponent of the pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.GaugePressure p_0(min=0, max=2e5, nominal=3e4) = 0
    "Threshold pressure (gauge) at full length"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure p_w(min=0, max=5e5, nominal=1e5) = 0
    "Pressure loss of the wall after it has bent open"
    annotation (Dialog(group="Effect"));
  parameter Real eps_w(unit="1", min=0.005, max=0.06, nominal=0.01) = 0.03
    "Contraction ratio over which the wall bends open"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Gauge pressure at which what it adds doubles its base";
  constant Real q_least(unit="1") = 0.02 "Least value of that";
  Real s(unit="1") = 8*x/L0 - 1 "Contraction beyond the reference, an eighth of the length, by the reference";
  constant Real z_most(unit="1") = 8 "Where the exponent is cut off, with a rounded corner";
equation
  f = k*x*exp(z_most*tanh(s*(a + s*(b + s*(c + d*s)))/z_most) + h*log(max(1 + p_gauge/p_reference, q_least)))
    + Functions.wallForce(p_gauge, x, L0, D0, turns, p_0, p_w, eps_w);
  annotation (defaultComponentName="bladder", Documentation(info="<html>
<p>f = k x (1 + p_gauge/100 kPa)^h exp(a s + b s^2 + c s^3 + d s^4) + the wall's force of
<a href=\"modelica://PneumaticMuscle.Effects.Elasticity.StiffWall\">StiffWall</a>, s = 8 x/L0 - 1, the exponent rounded
off at 8: as <a href=\"modelica://PneumaticMuscle.Effects.Elasticity.FlexibleBladder\">FlexibleBladder</a> with two more
terms of the expansion of ln(f/x), so that a slack, a stop, or a law that bends twice is met too: a stop at 80 mm within
1 %, a slack of 20 mm that ends with a corner within 3 %, of 30 mm within 4 %. Source: see there; the pressure thins a
bladder and presses it into the sleeve, whose fibres then stretch it between them
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Ferraresi, Franco and Bertetto 2001</a>). Typical k 50 to
2000 N/m, the others below 1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Elasticity.FlexibleBladder\">FlexibleBladder</a>.</p>
</html>"));
end GeneralBladder;

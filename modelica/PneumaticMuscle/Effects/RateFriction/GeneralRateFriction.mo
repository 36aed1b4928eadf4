within PneumaticMuscle.Effects.RateFriction;
model GeneralRateFriction "Friction that grows with any smooth function of speed, pressure, contraction and direction"
  extends FamilyMember(final general=true, final absent="c=0");
  parameter Types.TranslationalDamping c(min=0, max=2e4, nominal=100) = 100
    "Damping at 0.1 m/s, 100 kPa and full length"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-0.7, max=2, nominal=0.5) = 0 "Exponent of the damping at 0.1 m/s"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0
    "Quadratic coefficient of the exponent, by the logarithm of the speed"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="1", min=-0.05, max=0.05, nominal=0.03) = 0 "Cubic coefficient of the exponent"
    annotation (Dialog(group="Effect"));
  parameter Real pressure_share(unit="1", min=0, max=1, nominal=0.5) = 0.1 "Fraction that grows with the gauge pressure"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=0.2, max=3, nominal=1) = 1 "Exponent of the pressure in this fraction"
    annotation (Dialog(group="Effect"));
  parameter Real growth(unit="1", min=-2, max=3, nominal=0.5) = 0 "Exponent of the growth with the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-1, max=1, nominal=0.3) = 0
    "Relative asymmetry between contraction and extension"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Velocity v_reference = 0.1 "Speed at which the law equals c v";
  constant Types.Velocity v_smooth = 5e-4 "Speed below which the law is linear";
  constant Types.Pressure p_reference = 1e5 "Pressure at which the law equals c v";
  constant Real e_reference(unit="1") = 0.125 "Contraction at which the growth doubles its base, by the length";
  Types.Velocity v_size = sqrt(v^2 + v_smooth^2) "Rounded size of the speed";
  Real l(unit="1") = log(v_size/v_reference) "Logarithm of the speed by its reference";
  Real q(unit="1") = Functions.smoothMax(p_gauge/p_reference, 1e-3) "Gauge pressure by the reference, not below zero";
  Real s(unit="1") = Functions.smoothMax(x/(e_reference*L0), 0.02)
    "Contraction by the reference, zero beyond full length";
equation
  f = c*v*exp(l*(a + l*(b + d*l)) + growth*log(1 + s))*(1 + asymmetry*v/v_size)
    *(1 - pressure_share + pressure_share*exp(n*log(q)));
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = c v exp(a l + b l^2 + d l^3) (1 - pressure_share + pressure_share q^n) (1 + 8 x/L0)^growth (1 + asymmetry sgn
v), l = ln(|v|/0.1 m/s), q
= p_gauge/100 kPa: it dissipates, whatever the coefficients are. Source:
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.FlexibleRateFriction\">FlexibleRateFriction</a> and
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.UnevenFriction\">UnevenFriction</a>, see there, in one law,
with one more term in the logarithm of speed and a free exponent of the pressure. Typical c 20 to 1000 N.s/m, n 0.5 to
1, the others as there.</p>
<p>Fingerprint: as those.</p>
</html>"));
end GeneralRateFriction;

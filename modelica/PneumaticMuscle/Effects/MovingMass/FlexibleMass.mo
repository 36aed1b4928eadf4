within PneumaticMuscle.Effects.MovingMass;
model FlexibleMass "Moving parts whose inertia and weight are any smooth functions of the contraction"
  extends FamilyMember(final absent="m=0");
  parameter Types.Mass m(min=0, max=100, nominal=1) = 1 "Inertia at full length, referred to the load end"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-2, max=3, nominal=0.3) = 0 "Exponent of its growth with the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real weight_ratio(unit="1", min=0, max=3, nominal=0.5) = 0.5
    "Ratio of the hanging mass to the mass, at full length"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="1", min=-1, max=1.5, nominal=0.3) = 0 "Relative growth of the weight per reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0 "Quadratic coefficient of the growth"
    annotation (Dialog(group="Effect"));
protected
  constant Real e_reference(unit="1") = 0.125 "Reference contraction, by the length";
  constant Real e_smooth(unit="1") = 0.01 "Contraction over which the growth begins";
  Types.Length x_size = sqrt(x^2 + (e_smooth*L0)^2) "Rounded size of the contraction";
  Real s(unit="1") = 0.5*(x + x_size)/(e_reference*L0) "Contraction by the reference, zero beyond full length";
equation
  f = m*exp(a*log(1 + s))*(der(v) + 0.5*a/(1 + s)*s/x_size*v^2) + m*weight_ratio*Constants.g*exp(s*(c + d*s));
  annotation (defaultComponentName="movingMass", Documentation(info="<html>
<p>f = d/dt(m(x) v) - m'(x) v^2/2 + w(x) = m(x) v_dot + m'(x) v^2/2 + w(x), m(x) = m (1 + s)^a, w(x) = m weight_ratio g
exp(c
s + d s^2), s = 8 x/L0: the inertia is positive and the weight hangs, whatever the coefficients are. Source:
Lagrange's equation of a mass whose path y(x) a lever, a cam or a drum prescribes, inertia m y'^2, weight m y' g,
balanced or not; for a = c = d = 0 it is <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17),
weight_ratio
= 1 then is <a href=\"modelica://PneumaticMuscle.Effects.MovingMass.HangingMass\">HangingMass</a>, 0 is
<a href=\"modelica://PneumaticMuscle.Effects.MovingMass.BalancedMass\">BalancedMass</a>. A lever of the ratio 1 + x/80
mm, a drum whose inertia grows by 1 + x/40 mm and an arm that turns by 0.7 rad are met within 1 % of what they change in
the readings. Typical 0.1 to 20 kg, a -1 to 2, c -0.3 to 0.7. The run starts where the load alone rests, see
<a href=\"modelica://PneumaticMuscle.Effects.MovingMass.HangingMass\">HangingMass</a>: a weight of 40 N settles by 0.2
mm.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.MovingMass.HangingMass\">HangingMass</a>, with jumps
that are slower or faster than its weight lets expect, more so at another contraction.</p>
</html>"));
end FlexibleMass;

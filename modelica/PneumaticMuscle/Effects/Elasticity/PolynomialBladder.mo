within PneumaticMuscle.Effects.Elasticity;
model PolynomialBladder "The bladder is a spring whose stiffness changes with contraction"
  extends FamilyMember(final absent="k1=0, k2=0, k3=0");
  parameter Types.TranslationalStiffness k1(min=0, max=2e4, nominal=200) = 100 "Stiffness at rest"
    annotation (Dialog(group="Effect"));
  parameter Real k2(unit="N/m2", min=-2e3, max=2e5, nominal=2e3) = 0 "Quadratic coefficient"
    annotation (Dialog(group="Effect"));
  parameter Real k3(unit="N/m3", min=-2e4, max=2e6, nominal=2e4) = 0 "Cubic coefficient"
    annotation (Dialog(group="Effect"));
equation
  f = k1*x + k2*x^2 + k3*x^3;
  annotation (defaultComponentName="bladder", Documentation(info="<html>
<p>f = k1 x + k2 x^2 + k3 x^3. Source: Cao's polynomial model,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (7) and its reference 20, third order added so that
a rubber that stiffens with stretch is covered. Typical k1 as k of
<a href=\"modelica://PneumaticMuscle.Effects.Elasticity.LinearBladder\">LinearBladder</a>, k2 and k3 such that they add
as much again at a third of the length; a negative one softens the spring. Bounded where softening would make the muscle
run away by itself.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Elasticity.LinearBladder\">LinearBladder</a>, with an
error that grows faster (or slower) than the contraction.</p>
</html>"));
end PolynomialBladder;

within PneumaticMuscle.Effects.Elasticity;
model LinearBladder "The bladder is a linear spring"
  extends FamilyMember(final absent="k=0");
  parameter Types.TranslationalStiffness k(min=0, max=2e4, nominal=200) = 200 "Stiffness"
    annotation (Dialog(group="Effect"));
equation
  f = k*x;
  annotation (defaultComponentName="bladder", Documentation(info="<html>
<p>f = k x. Source: the spring of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Reynolds and others
2003</a>, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (6); typical 50 to 2000 N/m.</p>
<p>Fingerprint: contraction falls short in proportion to itself, in filling and holding alike; the pressure
hardly changes.</p>
</html>"));
end LinearBladder;

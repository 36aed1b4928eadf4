within PneumaticMuscle.Effects.RateFriction;
model ViscousFriction "Friction in proportion to speed"
  extends FamilyMember(final absent="c=0");
  parameter Types.TranslationalDamping c(min=0, max=2e4, nominal=100) = 100 "Damping"
    annotation (Dialog(group="Effect"));
equation
  f = c*v;
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = c v. Source: the viscous term of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5). Typical
20 to 1000 N.s/m.</p>
<p>Fingerprint: the contraction lags while it moves and is right when it rests.</p>
</html>"));
end ViscousFriction;

within PneumaticMuscle.Effects.DryFriction;
model CoulombFriction "Dry friction of constant size"
  extends FamilyMember(final absent="F_c=0");
  parameter Types.Force F_c(min=0, max=500, nominal=5) = 5 "Friction force" annotation (Dialog(group="Effect"));
  parameter Types.Velocity v_s(min=1e-6, max=5e-3, nominal=5e-4) = 1e-3
    "Speed at which the friction reaches three quarters of its size"
    annotation (Dialog(group="Effect"));
equation
  f = F_c*tanh(v_slip/v_s);
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = F_c tanh(v/v_s). Source: the Coulomb term of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(5), its jump smoothed as DP (69) does. Typical F_c 1 to 30 N for a muscle of 100 to 1000 N.</p>
<p>Fingerprint: the contraction lags in filling and in venting by the same force at every speed; contraction
against pressure is a loop whose width does not depend on the rate.</p>
</html>"));
end CoulombFriction;

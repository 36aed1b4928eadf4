within PneumaticMuscle.Effects.RateFriction;
model PowerLawFriction "Friction that grows with a power of speed"
  extends FamilyMember(final absent="c=0");
  parameter Types.TranslationalDamping c(min=0, max=2e4, nominal=100) = 100 "Damping at the reference speed"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=0.4, max=2.5) = 1.2 "Exponent" annotation (Dialog(group="Effect"));
protected
  constant Types.Velocity v_reference = 0.1 "Speed at which the law equals c v";
  constant Types.Velocity v_smooth = 1e-4 "Speed below which the law is linear";
equation
  f = c*v*((v^2 + v_smooth^2)/v_reference^2)^((a - 1)/2);
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = c v |v/v_ref|^(a-1), v_ref = 0.1 m/s: a = 1 is viscous, a = 2 quadratic, a below 1 shear-thinning.
Source: the viscous term of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5) with its exponent
left free (Ostwald and de Waele). Typical c 20 to 1000 N.s/m, a 0.5 to 2.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.RateFriction.ViscousFriction\">ViscousFriction</a>, with
another weight of fast against slow motion.</p>
</html>"));
end PowerLawFriction;

within PneumaticMuscle.Effects.RateFriction;
model PressureViscousFriction "Friction in proportion to speed and gauge pressure"
  extends FamilyMember(final absent="c_p=0");
  parameter Real c_p(unit="N.s/(m.Pa)", min=0, max=0.1, nominal=1e-3) = 1e-3 "Damping per gauge pressure"
    annotation (Dialog(group="Effect"));
equation
  f = c_p*p_gauge*v;
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = c_p p_gauge v. Source: the fibre friction <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(68) for slow motion, with its strength left free. Typical 1e-4 to 1e-2 N.s/(m.Pa).</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.RateFriction.ViscousFriction\">ViscousFriction</a>,
stronger at high pressure.</p>
</html>"));
end PressureViscousFriction;

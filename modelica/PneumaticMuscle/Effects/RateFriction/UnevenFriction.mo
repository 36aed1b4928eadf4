within PneumaticMuscle.Effects.RateFriction;
model UnevenFriction "Friction that grows with a power of speed, and differs by contraction, direction and pressure"
  extends FamilyMember(final absent="c=0");
  parameter Types.TranslationalDamping c(min=0, max=2e4, nominal=100) = 100
    "Damping at 0.1 m/s, 100 kPa and full length"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-0.9, max=2, nominal=0.5) = 0 "Exponent of the damping"
    annotation (Dialog(group="Effect"));
  parameter Real growth(unit="1", min=-2, max=3, nominal=0.5) = 0.1 "Exponent of its growth with the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-1, max=1, nominal=0.3) = 0.1
    "Relative asymmetry between contraction and extension"
    annotation (Dialog(group="Effect"));
  parameter Real pressure_share(unit="1", min=0, max=1, nominal=0.5) = 0.1 "Fraction proportional to the gauge pressure"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Velocity v_reference = 0.1 "Speed at which the law equals c v";
  constant Types.Velocity v_smooth = 5e-4 "Speed below which the law is linear";
  constant Types.Pressure p_reference = 1e5 "Pressure at which the law equals c v";
  constant Real e_reference(unit="1") = 0.125 "Contraction at which the growth doubles its base, by the length";
  Types.Velocity v_size = sqrt(v^2 + v_smooth^2) "Rounded size of the speed";
  Real s(unit="1") = Functions.smoothMax(x/(e_reference*L0), 0.02)
    "Contraction by the reference, zero beyond full length";
equation
  f = c*v*exp(a*log(v_size/v_reference) + growth*log(1 + s))*(1 + asymmetry*v/v_size)
    *(1 - pressure_share + pressure_share*Functions.smoothMax(p_gauge/p_reference, 1e-3));
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = c v |v/(0.1 m/s)|^a (1 + 8 x/L0)^growth (1 + asymmetry sgn v) (1 - pressure_share + pressure_share p_gauge/100
kPa): it dissipates,
whatever the coefficients are. Source: the viscous term of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5) by the power law of Ostwald and de Waele, the
pressure as in DP (68); fibres touch more of the bladder and cross at another angle as the muscle contracts, DP
(46)-(48), and a damper with a valve works one way. What doubles within 20 mm of contraction or works 3 times as much
one way is met within 1 % of what it changes in the readings. Typical c 20 to 1000 N.s/m, a -0.7 to 1, growth 0 to 1.5,
asymmetry -0.5 to 0.5.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.RateFriction.ViscousFriction\">ViscousFriction</a>, with
another weight of rising against falling, or of long against short.</p>
</html>"));
end UnevenFriction;

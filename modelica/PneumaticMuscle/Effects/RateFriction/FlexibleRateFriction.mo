within PneumaticMuscle.Effects.RateFriction;
model FlexibleRateFriction "Friction that grows with speed by any smooth law, and with pressure"
  extends FamilyMember(final absent="c=0");
  parameter Types.TranslationalDamping c(min=0, max=2e4, nominal=100) = 100 "Damping at 0.1 m/s and 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-1, max=2, nominal=0.5) = 0 "Exponent of the damping at 0.1 m/s"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.2, max=0.2, nominal=0.1) = 0
    "Quadratic coefficient of the exponent, by the logarithm of the speed"
    annotation (Dialog(group="Effect"));
  parameter Real pressure_share(unit="1", min=0, max=1, nominal=0.5) = 0.1 "Fraction proportional to the gauge pressure"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Velocity v_reference = 0.1 "Speed at which the law equals c v";
  constant Types.Pressure p_reference = 1e5 "Pressure at which the law equals c v";
equation
  f = c*v_reference*Functions.curvedPower(v/v_reference, a, b, 5e-3)
    *(1 - pressure_share + pressure_share*Functions.smoothMax(p_gauge/p_reference, 1e-3));
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = c v |u|^(a + b ln|u|) (1 - pressure_share + pressure_share p_gauge/100 kPa), u = v/(0.1 m/s),
<a href=\"modelica://PneumaticMuscle.Functions.curvedPower\">Functions.curvedPower</a>: it dissipates, whatever a, b and
pressure_share are. Source: the viscous term of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5)
by the
power law of Ostwald and de Waele, with one more term in the logarithm of speed; the pressure as in DP (68). Over 0.2
mm/s to 0.3 m/s it is within 3 % of power laws, of viscous plus quadratic and Coulomb plus viscous friction and of
Eyring's asinh, within 4 % of saturating ones, within 5 % of an exponential, and within 7 % where a Stribeck curve
falls; a strength that follows the square root of pressure is met within 6 %. Typical c 20 to 1000 N.s/m, a -0.7 to 1, b
-0.1 to 0.1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.RateFriction.ViscousFriction\">ViscousFriction</a>, with
another weight of fast against slow motion and of high against low pressure.</p>
</html>"));
end FlexibleRateFriction;

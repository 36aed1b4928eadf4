within PneumaticMuscle.Effects.RateFriction;
model LoadRateFriction "Friction in proportion to the pull and to the rate of strain"
  extends FamilyMember(final absent="ab=0");
  parameter Types.Time ab(min=0, max=50, nominal=1) = 1 "Product of the coefficients of load and of rate"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Force F_smooth = 0.1 "Force over which the pull is kept from becoming a push";
  Types.Force F "Pull of the sleeve by its pressure";
equation
  F = Functions.smoothMax(
    p_gauge*(3*(L0 - x)^2 - L0^2 - (turns*Constants.pi*D0)^2)/(4*Constants.pi*turns^2), F_smooth);
  f = ab*F*v/L0;
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = gamma_F gamma_f eps_dot, gamma_F = a F. Source: after
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (10)-(11), where F is the static load of the run
(<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.LoadFrequencyFriction\">LoadFrequencyFriction</a>). Here F is
the pull of the moment, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), and gamma_f = b times
the frequency of the excitation, which is one number in a test at one frequency: only the product ab = a gamma_f is
known from measurements, and it is one parameter here. Typical 0.1 to 10 s.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.RateFriction.ViscousFriction\">ViscousFriction</a>,
stronger under a large load, at the same pressure.</p>
</html>"));
end LoadRateFriction;

within PneumaticMuscle.Effects.RateFriction;
model LoadFrequencyFriction "Friction in proportion to the rate of strain, the run's load and the run's frequency"
  extends FamilyMember(final absent="ab=0");
  parameter Real ab(unit="s2", min=0, max=10, nominal=0.1) = 0.15 "Product of the coefficients of load and frequency"
    annotation (Dialog(group="Effect"));
protected
  outer Excitation excitation "Load and frequency of the run";
equation
  f = ab*excitation.F_load*excitation.frequency*v/L0;
  annotation (defaultComponentName="damper", Documentation(info="<html>
<p>f = gamma_F gamma_f eps_dot, gamma_F = a F, gamma_f = b f, with F the static load of the run and f the frequency of
its excitation. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (10)-(11). a and b stand
only in their product, so no measurement can separate them: the product is one parameter here. It lies beside the
friction that is there; where that has a constant coefficient c_v, DY put gamma_F gamma_f in its place, which is c_v =
0. Typical 0.01 to 1 s2; DY print no value.</p>
<p>Fingerprint: the loop of contraction by pressure widens with the load at the same frequency, and from run to run with
more than the rate of strain itself explains. At one load and one frequency it is
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.ViscousFriction\">ViscousFriction</a>: only runs at several of
both tell it. <a href=\"modelica://PneumaticMuscle.Effects.RateFriction.LoadRateFriction\">LoadRateFriction</a> follows
the pull of the moment, and knows no frequency.</p>
</html>"));
end LoadFrequencyFriction;

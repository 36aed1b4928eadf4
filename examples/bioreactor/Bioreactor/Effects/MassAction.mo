within Bioreactor.Effects;
model MassAction "Growth goes with the substrate, without a limit"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="mass_action", final balance="growth");
  constant Real S_1(unit="kg/m3") = 1 "Concentration at which the rate is mu_max";
equation
  mu = mu_max*S/S_1;
  annotation (Documentation(info="<html>
<p>mu = mu_max S/(1 kg/m3): mass action, what is left of every saturating law far below its half-saturation.
Source: F. F. Blackman, <i>Optima and limiting factors</i>, Ann. Bot. 19, 281, 1905.</p>
</html>"));
end MassAction;

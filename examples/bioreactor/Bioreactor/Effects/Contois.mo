within Bioreactor.Effects;
model Contois "A dense culture needs more substrate"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="contois", final balance="growth");
  parameter Real K_X(unit="1", min=0.002, max=100, nominal=1) = 0.5 "Substrate over biomass at which the rate is half of mu_max";
equation
  mu = mu_max*S/(K_X*X + S);
  annotation (Documentation(info="<html>
<p>mu = mu_max S/(K_X X + S). Source: D. E. Contois, <i>Kinetics of bacterial growth: relationship between population density and
specific growth rate of continuous cultures</i>, J. Gen. Microbiol. 21, 40, 1959.</p>
</html>"));
end Contois;

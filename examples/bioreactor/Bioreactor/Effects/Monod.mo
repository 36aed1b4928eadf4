within Bioreactor.Effects;
model Monod "Growth saturates with the substrate"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="monod", final balance="growth");
  parameter Real K_S(unit="kg/m3", min=0.02, max=100, nominal=1) = 1 "Concentration at which the rate is half of mu_max";
equation
  mu = mu_max*S/(K_S + S);
  annotation (Documentation(info="<html>
<p>mu = mu_max S/(K_S + S). Source: J. Monod, <i>The growth of bacterial cultures</i>, Annu. Rev. Microbiol. 3, 371, 1949.</p>
</html>"));
end Monod;

within Bioreactor.Effects;
model Tessier "Growth saturates exponentially with the substrate"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="tessier", final balance="growth");
  parameter Real K_S(unit="kg/m3", min=0.02, max=100, nominal=1) = 1 "Concentration over which growth saturates";
equation
  mu = mu_max*(1 - exp(-S/K_S));
  annotation (Documentation(info="<html>
<p>mu = mu_max (1 - exp(-S/K_S)). Source: G. Tessier, <i>Croissance des populations bactériennes et quantité d’aliment
disponible</i>, Rev. Sci. Paris 80, 209, 1942.</p>
</html>"));
end Tessier;

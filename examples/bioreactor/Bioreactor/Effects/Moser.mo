within Bioreactor.Effects;
model Moser "Growth saturates with a power of the substrate"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="moser", final balance="growth");
  parameter Real K_S(unit="kg/m3", min=0.02, max=100, nominal=1) = 1 "Concentration at which the rate is half of mu_max";
  parameter Real n(unit="1", min=1, max=4) = 2 "Exponent";
equation
  mu = mu_max*(S/K_S)^2*sqrt((S/K_S)^2 + 1e-6)^(n - 2)/(1 + (S/K_S)^2*sqrt((S/K_S)^2 + 1e-6)^(n - 2));
  annotation (Documentation(info="<html>
<p>mu = mu_max S<sup>n</sup>/(K_S<sup>n</sup> + S<sup>n</sup>), rounded below S = K_S/1000. Source: H. Moser, <i>The dynamics of bacterial
populations maintained in the chemostat</i>, Carnegie Institution of Washington, publication 614, 1958.</p>
</html>"));
end Moser;

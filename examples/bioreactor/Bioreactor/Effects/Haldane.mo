within Bioreactor.Effects;
model Haldane "Too much substrate slows growth"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="haldane", final balance="growth");
  parameter Real K_S(unit="kg/m3", min=0.02, max=100, nominal=1) = 1 "Concentration at which the rate is half of mu_max";
  parameter Real K_I(unit="kg/m3", min=0.5, max=5000, nominal=50) = 50 "Concentration over which too much substrate slows growth";
equation
  mu = mu_max*S/(K_S + S + S^2/K_I);
  annotation (Documentation(info="<html>
<p>mu = mu_max S/(K_S + S + S²/K_I). Source: J. F. Andrews, <i>A mathematical model for the continuous culture of microorganisms
utilizing inhibitory substrates</i>, Biotechnol. Bioeng. 10, 707, 1968, after J. B. S. Haldane, <i>Enzymes</i>, 1930.</p>
</html>"));
end Haldane;

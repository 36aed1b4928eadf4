within Bioreactor.Effects;
model Edwards "Too much substrate slows growth exponentially"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="edwards", final balance="growth");
  parameter Real K_S(unit="kg/m3", min=0.02, max=100, nominal=1) = 1 "Concentration at which the rate is half of mu_max";
  parameter Real K_I(unit="kg/m3", min=0.5, max=5000, nominal=50) = 50 "Concentration over which too much substrate slows growth";
equation
  mu = mu_max*S/(K_S + S)*exp(-S/K_I);
  annotation (Documentation(info="<html>
<p>mu = mu_max S/(K_S + S) exp(-S/K_I). Source: V. H. Edwards, <i>The influence of high substrate concentrations on microbial
kinetics</i>, Biotechnol. Bioeng. 12, 679, 1970, after S. Aiba, M. Shoda and M. Nagatani, 1968.</p>
</html>"));
end Edwards;

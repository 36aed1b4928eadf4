within Bioreactor.Effects;
model Verhulst "A dense culture stops growing"
  extends Interfaces.Kinetics;
  extends Interfaces.Effect(final family="verhulst", final balance="growth", final absent="X_max=1e6");
  parameter Real X_max(unit="kg/m3", min=0.5, max=1e6, nominal=10) = 20 "Biomass at which growth stops";
  constant Real S_0(unit="kg/m3") = 0.02 "Concentration over which the last substrate goes, as in ConstantRate";
equation
  mu = mu_max*(1 - X/X_max)*S/(S + S_0);
  annotation (Documentation(info="<html>
<p>mu = mu_max (1 - X/X_max) while there is substrate. Source: P.-F. Verhulst, <i>Notice sur la loi que la population suit dans son
accroissement</i>, Corr. Math. Phys. 10, 113, 1838.</p>
</html>"));
end Verhulst;

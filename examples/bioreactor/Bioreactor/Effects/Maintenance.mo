within Bioreactor.Effects;
model Maintenance "Substrate that is spent on staying alive"
  extends Interfaces.CultureEffect(final family="maintenance", final balance="substrate", final absent="m=0");
  parameter Real m(unit="1/s", min=0, max=2e-4, nominal=1e-5) = 1e-6 "Substrate over biomass and time";
  constant Real S_0(unit="kg/m3") = 0.02 "Concentration over which the last substrate goes, as in ConstantRate";
equation
  r_S = m*X*S/(S + S_0);
  r_X = 0;
  annotation (Documentation(info="<html>
<p>r_S = m X while there is substrate. Source: S. J. Pirt, <i>The maintenance energy of bacteria in growing cultures</i>,
Proc. R. Soc. Lond. B 163, 224, 1965.</p>
</html>"));
end Maintenance;

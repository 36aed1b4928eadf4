within Bioreactor.Effects;
model Decay "Biomass that dies or feeds on itself"
  extends Interfaces.CultureEffect(final family="decay", final balance="biomass", final absent="k_d=0");
  parameter Real k_d(unit="1/s", min=0, max=2e-4, nominal=1e-5) = 1e-6 "Share of the biomass that is lost in a time";
equation
  r_S = 0;
  r_X = k_d*X;
  annotation (Documentation(info="<html>
<p>r_X = k_d X. Source: D. Herbert, <i>Some principles of continuous culture</i>, in: Recent Progress in Microbiology, 1958, 381.</p>
</html>"));
end Decay;

within Bioreactor.Components;
model ConstantRate "The rate that cells have whenever there is substrate"
  extends Interfaces.Kinetics;
  constant Real S_0(unit="kg/m3") = 0.02 "Concentration over which the last substrate goes; below what is measured";
equation
  mu = mu_max*S/(S + S_0);
  annotation (Documentation(info="<html><p>Exponential growth until the substrate is gone. Source: T. R. Malthus, <i>An Essay on the
Principle of Population</i>, 1798.</p></html>"));
end ConstantRate;

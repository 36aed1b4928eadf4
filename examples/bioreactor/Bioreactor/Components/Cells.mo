within Bioreactor.Components;
model Cells "Growth, and the substrate that it takes"
  extends Interfaces.Culture;
  parameter Real mu_max(unit="1/s", min=0, max=1e-3, nominal=1e-4) = 5e-5 "Specific rate of growth";
  parameter Real Y(unit="1", min=0.01, max=1) = 0.5 "Yield, biomass over substrate";
  replaceable model Kinetics = ConstantRate constrainedby Interfaces.Kinetics "Law of the rate" annotation (choicesAllMatching=true);
  Kinetics kinetics(mu_max=mu_max, S=broth.S, X=broth.X) "Rate of growth";
equation
  broth.m_X = -kinetics.mu*broth.X*broth.V;
  broth.m_S = kinetics.mu/Y*broth.X*broth.V;
  broth.q = 0;
end Cells;

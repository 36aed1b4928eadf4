within PneumaticMuscle.Effects.GasEnergy;
model FlexibleGas "Mass and energy balance, with heat exchange that grows with density, temperature difference and flow"
  extends BalancedGas;
  extends FamilyMember;
  parameter Types.CoefficientOfHeatTransfer h_0(min=0.01, max=500, nominal=10) = 5 "Film coefficient of gas at rest"
    annotation (Dialog(group="Effect"));
  parameter Types.CoefficientOfHeatTransfer h_1(min=0, max=2e3, nominal=10) = 5 "Increase at the reference flow"
    annotation (Dialog(group="Effect"));
  parameter Real n_p(unit="1", min=-0.5, max=1.5, nominal=0.5) = 0.2 "Exponent of the pressure at rest"
    annotation (Dialog(group="Effect"));
  parameter Real n_T(unit="1", min=0, max=0.5, nominal=0.3) = 0.1 "Exponent of the temperature difference at rest"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau_jet(min=2e-3, max=5, nominal=0.05) = 0.05 "Time constant of the decay of a jet"
    annotation (Dialog(group="Effect"));
  outer Ambient ambient "Surroundings";
  Types.MassFlowRate m_jet(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Flow that the gas still feels";
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow at which h_1 is added";
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow below which its size is rounded";
  constant Real T_reference_difference(unit="K") = 10 "Temperature difference at which h_0 is meant";
  constant Real T_smooth(unit="K") = 1 "Temperature difference below which its size is rounded";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(m_jet) = 0;
  end if;
equation
  tau_jet*der(m_jet) = port.m_flow - m_jet;
  h_wall = h_0*exp(n_p*log(max(p, 1.0)/ambient.p)
      + 0.5*n_T*log(((T - ambient.T)^2 + T_smooth^2)/T_reference_difference^2))
    + h_1*((m_jet^2 + m_smooth^2)/m_reference^2)^0.4;
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.ConvectiveGas\">ConvectiveGas</a> with h = h_0
(p/p_atm)^n_p (|T - T_atm|/10 K)^n_T + h_1 (|m_jet|/0.1 g/s)^0.8, tau_jet m_jet_dot = m_flow - m_jet. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53), (54), (59); free convection has Nu ~ (Gr
Pr)^n with Gr in proportion to density squared and temperature difference, n = 1/4 laminar and 1/3 turbulent
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">McAdams 1954</a>), so n_p = 2 n, n_T = n; conduction alone
has neither. DP (60) falls away, so that no value of the parameters gives the base law back. Where the flow counts by an
exponent of 0.6 the readings keep 1 % of what the balance changes. Typical h_0 2 to 10, h_1 5 to 200 W/(m2.K), n_p 0 to
0.67, n_T 0 to 0.33, tau_jet 0.02 to 0.5 s.</p>
<p>Open: a muscle's wall takes the same film, with jet and pressure of the inside, for its outer side too, see
<a href=\"modelica://PneumaticMuscle.Laws.Heat.FilmWall\">Laws.Heat.FilmWall</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.ConvectiveGas\">ConvectiveGas</a>; after
filling the temperature returns to ambient fast at first and then slowly.</p>
</html>"));
end FlexibleGas;

within PneumaticMuscle.Effects.GasEnergy;
model GeneralGas "Mass and energy balance of any gas, with any smooth law of its heat exchange"
  extends Interfaces.Gas(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final general=true);
  parameter Types.CoefficientOfHeatTransfer h_0(min=0.01, max=500, nominal=10) = 5 "Film coefficient of gas at rest"
    annotation (Dialog(group="Effect"));
  parameter Types.CoefficientOfHeatTransfer h_1(min=0, max=2e3, nominal=10) = 5 "Increase at the reference flow"
    annotation (Dialog(group="Effect"));
  parameter Real n_p(unit="1", min=-0.5, max=1.5, nominal=0.5) = 0.2 "Exponent of the pressure at rest"
    annotation (Dialog(group="Effect"));
  parameter Real n_d(unit="1", min=0, max=0.5, nominal=0.3) = 0.1 "Exponent of the temperature difference at rest"
    annotation (Dialog(group="Effect"));
  parameter Real n_T(unit="1", min=-3, max=3, nominal=1) = 0 "Exponent of the temperature"
    annotation (Dialog(group="Effect"));
  parameter Real n_V(unit="1", min=-2, max=2, nominal=0.5) = 0 "Exponent of the volume"
    annotation (Dialog(group="Effect"));
  parameter Real n_m(unit="1", min=0.3, max=1.2, nominal=0.8) = 0.8 "Exponent of the flow"
    annotation (Dialog(group="Effect"));
  parameter Real out(unit="1", min=0, max=2, nominal=0.5) = 1 "Ratio of the stirring by outflow to that by inflow"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau_jet(min=2e-3, max=5, nominal=0.05) = 0.05 "Time constant of the decay of a jet"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="m3/kg", min=-0.05, max=0.05, nominal=1e-3) = 0
    "Covolume of the gas minus the effect of attraction"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-3e-3, 7e-3}));
  parameter Real e(unit="1", min=0, max=1, nominal=1) = 0.6 "Fraction of the attraction in the internal energy"
    annotation (Dialog(group="Effect"));
  Types.Mass m(nominal=1e-3) "Mass of the gas";
  outer Ambient ambient "Surroundings";
  Types.MassFlowRate m_jet(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Flow that the gas still feels";
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow at which h_1 is added";
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow below which its size is rounded";
  constant Types.Volume V_reference = 1e-4 "Volume at which h_0 and h_1 are meant";
  constant Real T_reference_difference(unit="K") = 10 "Temperature difference at which h_0 is meant";
  constant Real T_smooth(unit="K") = 1 "Temperature difference below which its size is rounded";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
    der(m_jet) = 0;
  end if;
equation
  p*(V - b*m) = m*Constants.R*T;
  m*Constants.R*der(T) = (V - b*m)*der(p) + p*der(V) - (Constants.R*T + b*p)*port.m_flow;
  (V - e*b*m)*der(p) = -Constants.gamma*p*(der(V) - b*port.m_flow) + (Constants.gamma - 1)*(heatPort.Q_flow + port.H_flow);
  tau_jet*der(m_jet) = 0.5*((1 + out)*sqrt(port.m_flow^2 + m_smooth^2) + (1 - out)*port.m_flow) - m_jet;
  h_wall = exp(n_T*log(max(T, 1.0)/ambient.T) + n_V*log(V/V_reference))*(h_0*exp(n_p*log(max(p, 1.0)/ambient.p)
      + 0.5*n_d*log(((T - ambient.T)^2 + T_smooth^2)/T_reference_difference^2))
    + h_1*exp(0.5*n_m*log((m_jet^2 + m_smooth^2)/m_reference^2)));
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.RealGas\">RealGas</a> with h = (T/T_atm)^n_T (V/0.1
L)^n_V (h_0 (p/p_atm)^n_p (|T - T_atm|/10 K)^n_d + h_1 (|m_jet|/0.1 g/s)^n_m), tau_jet m_jet_dot = |m_flow| - m_jet,
where flow out counts out times: a jet stirs, what leaves towards the opening hardly does (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martin 1977</a>). Source: <a
href=\"modelica://PneumaticMuscle.Effects.GasEnergy.FlexibleGas\">FlexibleGas</a> and <a
href=\"modelica://PneumaticMuscle.Effects.GasEnergy.RealGas\">RealGas</a>, see there; Nusselt numbers are products of
powers of the gas' properties, of the size of the space and of the flow (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">McAdams 1954</a>). <a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (60) falls away, so that no value of the parameters
gives the base law back. Typical as there, n_T and n_V -1 to 1, out 0 to 1.</p>
<p>Open: a muscle's wall takes the same film, with jet and pressure of the inside, for its outer side too, see
<a href=\"modelica://PneumaticMuscle.Laws.Heat.FilmWall\">Laws.Heat.FilmWall</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.FlexibleGas\">FlexibleGas</a>.</p>
</html>"));
end GeneralGas;

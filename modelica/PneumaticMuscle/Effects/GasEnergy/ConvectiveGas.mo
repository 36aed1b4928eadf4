within PneumaticMuscle.Effects.GasEnergy;
model ConvectiveGas "Mass and energy balance, with heat exchange that grows with the flow"
  extends BalancedGas;
  extends FamilyMember;
  parameter Types.CoefficientOfHeatTransfer h_0(min=0.01, max=500, nominal=10) = 5 "Film coefficient of gas at rest"
    annotation (Dialog(group="Effect"));
  parameter Types.CoefficientOfHeatTransfer h_1(min=0, max=2e3, nominal=10) = 10 "Increase at the reference flow"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="EnergyGas"));
  Types.MassFlowRate m_jet(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Flow that the gas still feels";
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow at which h_1 is added";
  constant Types.Time tau_jet = 0.05 "Time constant of the decay of a jet";
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow below which its size is rounded";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(m_jet) = 0;
  end if;
equation
  tau_jet*der(m_jet) = port.m_flow - m_jet;
  h_wall = h_0 + h_1*((m_jet^2 + m_smooth^2)/m_reference^2)^0.4;
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">EnergyGas</a> with h = h_0 + h_1 (|m_flow|/0.1
g/s)^0.8. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53), (54), (59); exponent:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Dittus and Boelter 1930</a> for turbulent flow, Nu ~
Re^0.8; a jet stirs the gas while it is filled and for 0.05 s after, free convection is left in a hold. DP (60) falls
away, so that no value of h_0 and h_1 gives the base law back. Typical h_0 3 to 10, h_1 5 to 200 W/(m2.K).</p>
<p>Open: a muscle's wall takes the same film, with the jet of the inside, for its outer side too, see
<a href=\"modelica://PneumaticMuscle.Laws.Heat.FilmWall\">Laws.Heat.FilmWall</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">EnergyGas</a>, with less heating
while gas flows than the slow return to ambient in the hold lets expect.</p>
</html>"));
end ConvectiveGas;

within PneumaticMuscle.Laws.Lines;
model TurbulentTube "A long tube with isothermal turbulent flow"
  extends Interfaces.TwoGasPorts;
  extends Icons.Line;
  parameter Types.Area A "Effective area: cross-section by the root of friction factor and slenderness"
    annotation (Dialog(group="Flow"));
  outer Ambient ambient "Surroundings";
protected
  constant Real z_laminar = 1e-3 "Relative drop of the squared pressure below which the flow is laminar";
  Real z = (port_a.p^2 - port_b.p^2)/(port_a.p^2 + port_b.p^2) "Relative drop of the squared pressure";
equation
  m_flow = A*sqrt((port_a.p^2 + port_b.p^2)/(Constants.R*ambient.T))*z/(z^2 + z_laminar^2)^0.25;
  annotation (Documentation(info="<html>
<p>m_flow = A sqrt((p_a^2 - p_b^2)/(R T_atm)) with A = (pi d^2/4)/sqrt(f l/d): isothermal flow with a constant friction
factor f through a tube so long that f l/d is large compared with the logarithm of the pressure ratio,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Shapiro 1953</a>. Rounded where the squared pressures
differ by less than 0.1 %.</p>
</html>"));
end TurbulentTube;

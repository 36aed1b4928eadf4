within PneumaticMuscle.Effects.GasEnergy;
model RealGas "Mass and energy balance of a gas that is not ideal"
  extends Interfaces.Gas(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember;
  parameter Types.CoefficientOfHeatTransfer h(min=0.01, max=500, nominal=10) = 10 "Film coefficient at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real n_p(unit="1", min=-0.5, max=1.5, nominal=0.5) = 0.2 "Exponent of the pressure"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="m3/kg", min=-0.05, max=0.05, nominal=1e-3) = -4e-4
    "Covolume of the gas minus the effect of attraction"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-3e-3, 7e-3}));
  parameter Real e(unit="1", min=0, max=1, nominal=1) = 0.6 "Fraction of the attraction in the internal energy"
    annotation (Dialog(group="Effect"));
  Types.Mass m(nominal=1e-3) "Mass of the gas";
  outer Ambient ambient "Surroundings";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
  end if;
equation
  p*(V - b*m) = m*Constants.R*T;
  m*Constants.R*der(T) = (V - b*m)*der(p) + p*der(V) - (Constants.R*T + b*p)*port.m_flow;
  (V - e*b*m)*der(p) = -Constants.gamma*p*(der(V) - b*port.m_flow) + (Constants.gamma - 1)*(heatPort.Q_flow + port.H_flow);
  h_wall = h*exp(n_p*log(max(p, 1.0)/ambient.p));
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">EnergyGas</a> with p (V - b m) = m R T, that is
Z = 1 + b p/(R T), U = p (V - e b m)/(gamma - 1), and h (p/p_atm)^n_p in place of h. Source: the virial equation to its
second term, and van der Waals' equation, of which e is 1 for the volume of the molecules and 2 - gamma = 0.6 for their
attraction; b = -3e-4 m3/kg for air and -3e-3 to 7e-3 for other gases at room temperature
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Dymond and Smith 1980</a>). The film is that of free
convection, Nu ~ Gr^n, n_p = 2 n. <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (60) falls away,
so that no value of the parameters gives the base law back. Typical h 5 to 50 W/(m2.K), n_p 0 to 0.67.</p>
<p>The balance of energy: H = U + p V is m c_p T + p b m (gamma - e)/(gamma - 1). Ports carry c_p T alone; with the rest
at the pressure inside, whatever flows in or out, U_dot = H_flow - p V_dot + Q_flow becomes (V - e b m) p_dot = gamma p
(b m_dot - V_dot) + (gamma - 1) (H_flow of the port + Q_flow). So p (V/m - e b)^gamma stays while a vessel without heat
is vented, as du = -p dv wants it.</p>
<p>Open: what flows in comes with the temperature of the port at the pressure inside; what throttling down from the
supply changes in it, b (gamma - e)/(gamma R) by the drop of pressure, is left out. The film holds for both sides of a
muscle's wall, see
<a href=\"modelica://PneumaticMuscle.Laws.Heat.FilmWall\">Laws.Heat.FilmWall</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">EnergyGas</a>, and in dense gas
the temperature is off in proportion to the pressure, in holds too.</p>
</html>"));
end RealGas;

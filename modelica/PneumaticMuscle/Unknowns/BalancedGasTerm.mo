within PneumaticMuscle.Unknowns;
partial model BalancedGasTerm "Gas that keeps books of mass and energy, and a further heat flow into it"
  extends Interfaces.Gas(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends Icons.Unknown;
  outer Ambient ambient "Surroundings";
  Types.Power missing "Heat flow, positive into the gas";
  Types.Mass m(nominal=1e-3) "Mass of the gas";
  Types.GaugePressure p_gauge "Gauge pressure";
  Real T_excess(unit="K") "Temperature of the gas above that of the surroundings";
  Types.MassFlowRate m_rate "Rate of the mass";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
  end if;
equation
  m_rate = port.m_flow;
  p*V = m*Constants.R*T;
  m*Constants.R*der(T) = V*der(p) + p*der(V) - Constants.R*T*port.m_flow;
  V*der(p) = -Constants.gamma*p*der(V) + (Constants.gamma - 1)*(heatPort.Q_flow + missing + port.H_flow);
  h_wall = h_film;
  p_gauge = p - ambient.p;
  T_excess = T - ambient.T;
  annotation (Documentation(info="<html>
<p>Ideal gas with mass and energy balance, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43),
(53), (54), (59), in the place of a law that fixes the temperature by the pressure. Left to the extending class: the
equation of <code>missing</code>, the heat that must come through the wall beyond the film coefficient that the owner
assumes. It is not zero where the polytropic law was right.</p>
</html>"));
end BalancedGasTerm;

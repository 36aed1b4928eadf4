within PneumaticMuscle.Unknowns;
partial model BalancedGasTerm "Gas that keeps books of mass and energy, and a further heat flow into it"
  extends Effects.GasEnergy.BalancedGas(Q_flow=heatPort.Q_flow + missing);
  extends Icons.Unknown;
  outer Ambient ambient "Surroundings";
  Types.Power missing "Heat flow, positive into the gas";
  Types.GaugePressure p_gauge "Gauge pressure";
  Real T_excess(unit="K") "Temperature of the gas above that of the surroundings";
  Types.MassFlowRate m_rate "Rate of the mass";
equation
  m_rate = port.m_flow;
  h_wall = h_film;
  p_gauge = p - ambient.p;
  T_excess = T - ambient.T;
  annotation (Documentation(info="<html>
<p>In the place of a law that fixes the temperature by the pressure. Left to the extending class: the equation of
<code>missing</code>, the heat that must come through the wall beyond the film coefficient that the owner assumes. It is
not zero where the polytropic law was right.</p>
</html>"));
end BalancedGasTerm;

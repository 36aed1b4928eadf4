within PneumaticMuscle.Effects.GasEnergy;
partial model BalancedGas "Pressure and temperature of an ideal gas from its mass and energy"
  extends Interfaces.Gas(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  Types.Mass m(nominal=1e-3) "Mass of the gas";
  Types.Power Q_flow = heatPort.Q_flow "Heat flow into the gas";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
  end if;
equation
  p*V = m*Constants.R*T;
  m*Constants.R*der(T) = V*der(p) + p*der(V) - Constants.R*T*port.m_flow;
  V*der(p) = -Constants.gamma*p*der(V) + (Constants.gamma - 1)*(Q_flow + port.H_flow);
  annotation (Documentation(info="<html>
<p>The balances <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53), (54), (59). That of the
mass, m_dot = m_flow, is written for the temperature with p V = m R T, so that the states are what is measured: where a
run begins at a known pressure, the temperature is still that of the surroundings or at rest, whether the gas is at rest
or flows. Left to the extending class: the equation of h_wall.</p>
</html>"));
end BalancedGas;

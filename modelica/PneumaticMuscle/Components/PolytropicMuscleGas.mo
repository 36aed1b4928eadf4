within PneumaticMuscle.Components;
model PolytropicMuscleGas "Pressure from the energy balance, temperature from a polytropic law, DP (59)-(60)"
  extends Interfaces.Gas;
equation
  V*der(p) = -Constants.gamma*p*der(V) + (Constants.gamma - 1)*(heatPort.Q_flow + port.H_flow);
  T = T_reference*(p/p_reference)^((n - 1)/n);
  h_wall = h_film;
  annotation (Documentation(info="<html>
<p>p_dot = (-gamma p V_dot + (gamma - 1) Q_dot + gamma R (T_1 m_in - T_2 m_out))/V, DP (59), and
T_2 = T_atm (p/p_atm)^((n_g - 1)/n_g), DP (60). The two are not consistent with each other: (60) fixes the
temperature without asking how much gas there is. <code>Effects.EnergyGas</code> mends that.</p>
</html>"));
end PolytropicMuscleGas;

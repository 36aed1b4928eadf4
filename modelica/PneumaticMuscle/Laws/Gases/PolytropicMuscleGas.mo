within PneumaticMuscle.Laws.Gases;
model PolytropicMuscleGas "Pressure from the energy balance, temperature from a polytropic law, DP (59)-(60)"
  extends Interfaces.Gas;
equation
  V*der(p) = -Constants.gamma*p*der(V) + (Constants.gamma - 1)*(heatPort.Q_flow + port.H_flow);
  T = T_reference*(p/p_reference)^((n - 1)/n);
  h_wall = h_film;
  annotation (Documentation(info="<html>
<p>p_dot = (-gamma p V_dot + (gamma - 1) Q_dot + gamma R (T_1 m_in - T_2 m_out))/V,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (59), and T_2 = T_atm (p/p_atm)^((n_g - 1)/n_g), DP
(60) read as the power law of a polytropic process. The two are not consistent with each other: (60) fixes the
temperature without asking how much gas there is.
<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a> mends that.</p>
<p>The reading is not the printed one. DP (60) stands as a product, t/T = (n_g - 1)/n_g p/P, without an exponent, and
the text says that it \"relies on pressure variation\". Absolute t and p in it would give 0 K for n_g = 1; small
variations about T and P make it the differential of the power law, which integrates to that law again. The power law
heats the gas by 110 K at 207 kPa and n_g = 1.4 where DP's model has \"approximately 4 degC\", so it is not what DP ran;
what they did run cannot be told from the paper.
<a href=\"modelica://PneumaticMuscle.Examples.Validation.GasTemperature\">Validation.GasTemperature</a> compares.</p>
<p>Signs: DP (43) adds W, \"the work done on the muscle\", and DP (50) reads W = P_2 V_dot, which would warm a gas that
expands; the line before (59), and (59), have -P_2 V_dot. The gas does work as it expands: -p V_dot is used (the text of
the paper that was at hand drops some minus signs; that of (50) may be one). The same line has h_1 and h_2 behind
gamma R where (59) rightly has T_1 and T_2.</p>
</html>"));
end PolytropicMuscleGas;

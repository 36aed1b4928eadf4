within PneumaticMuscle.Effects.DeadVolume;
model SideVolume "Gas that takes no part in contraction, behind an opening, in a space that takes its heat"
  extends Chamber(final absent="V=1e-7, G=1e-7");
equation
  port.m_flow = G*(port.p^2 - p_s^2)/(2*ambient.p);
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, p_s, port.T, T_s);
  annotation (defaultComponentName="deadVolume", Documentation(info="<html>
<p>m_flow = G (p^2 - p_s^2)/(2 p_atm), p_s V = m R T_s, V p_s_dot = (gamma - 1) (c_p T_up m_flow - UA (T_s - T_atm)).
Source: the balances <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53) and (59) of a rigid
space; isothermal laminar flow through its opening. With a large G and no UA the gas in it is compressed as that of the
muscle, with a large UA it stays at ambient temperature. Chambers of 30 mL behind an opening of a linear law are met
within 2 % of what they change in the readings. Typical 1 to 30 mL, G 1e-9 to 5e-8 kg/(s.Pa), UA 0.001 to 0.5 W/K.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume.DeadVolume\">DeadVolume</a>, with a pressure
that still falls after filling and rises after venting.</p>
</html>"));
end SideVolume;

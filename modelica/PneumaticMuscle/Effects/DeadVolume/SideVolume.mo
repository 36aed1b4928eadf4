within PneumaticMuscle.Effects.DeadVolume;
model SideVolume "Gas that takes no part in contraction, behind an opening, in a space that takes its heat"
  extends FamilyMember(final absent="V=1e-7, G=1e-7");
  parameter Types.Volume V(min=1e-7, max=1e-3, nominal=1e-5) = 1e-5 "Volume" annotation (Dialog(group="Effect"));
  parameter Real G(unit="kg/(s.Pa)", min=1e-11, max=1e-7, nominal=1e-9) = 2e-9
    "Conductance of the opening at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance UA(min=0, max=50, nominal=0.02) = 0.02
    "Conductance from its gas to what stays at ambient temperature"
    annotation (Dialog(group="Effect"));
  Types.AbsolutePressure p_s(start=ambient.p) "Pressure in it";
  Types.Temperature T_s(start=ambient.T) "Temperature in it";
  Types.Mass m(nominal=1e-5) "Mass of the gas in it";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    p_s = port.p;
    T_s = port.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(p_s) = 0;
    der(m) = 0;
  end if;
equation
  der(m) = port.m_flow;
  p_s*V = m*Constants.R*T_s;
  V*der(p_s) = (Constants.gamma - 1)*(port.H_flow - UA*(T_s - ambient.T));
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

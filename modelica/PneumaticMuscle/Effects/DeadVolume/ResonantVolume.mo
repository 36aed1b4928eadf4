within PneumaticMuscle.Effects.DeadVolume;
model ResonantVolume "Gas that takes no part in contraction, behind a neck whose gas has inertia"
  extends FamilyMember(final absent="V=1e-7, G=1e-7, I=1e3");
  parameter Types.Volume V(min=1e-7, max=1e-3, nominal=1e-5) = 1e-5 "Volume" annotation (Dialog(group="Effect"));
  parameter Real G(unit="kg/(s.Pa)", min=1e-10, max=1e-7, nominal=1e-8) = 1e-8
    "Conductance of the neck at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real I(unit="1/m", min=1e3, max=1e7, nominal=1e5) = 3e4 "Inertance: length of the neck by its section"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance UA(min=0, max=50, nominal=0.02) = 0.01
    "Conductance from its gas to what stays at ambient temperature"
    annotation (Dialog(group="Effect"));
  Types.AbsolutePressure p_s(start=ambient.p) "Pressure in it";
  Types.Temperature T_s(start=ambient.T) "Temperature in it";
  Types.Mass m(nominal=1e-5) "Mass of the gas in it";
  Types.MassFlowRate m_neck(start=0, nominal=1e-4) "Flow in the neck";
protected
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow over which the sides upstream blend";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    p_s = port.p;
    T_s = port.T;
    m_neck = 0;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(p_s) = 0;
    der(m) = 0;
    der(m_neck) = 0;
  end if;
equation
  der(m) = m_neck;
  p_s*V = m*Constants.R*T_s;
  V*der(p_s) = (Constants.gamma - 1)*(port.H_flow - UA*(T_s - ambient.T));
  I*der(m_neck) = port.p - p_s - m_neck/G*2*ambient.p/(port.p + p_s);
  port.m_flow = m_neck;
  port.H_flow = m_neck*Constants.cp*(T_s + (port.T - T_s)*0.5*(1 + m_neck/sqrt(m_neck^2 + m_smooth^2)));
  annotation (defaultComponentName="deadVolume", Documentation(info="<html>
<p>I m_flow_dot = p - p_s - 2 p_atm/(p + p_s) m_flow/G, and the balances of <a
href=\"modelica://PneumaticMuscle.Effects.DeadVolume.SideVolume\">SideVolume</a>, which is the case of a small I.
Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Helmholtz 1863</a>; the inertance I is the length
of the neck by its section, 1e5/m for 0.3 m of 2 mm bore; friction is laminar, by the mean density in the neck.
Typical 1 to 30 mL, I 1e4 to 3e5/m, G 5e-9 to 5e-8 kg/(s.Pa).</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume.SideVolume\">SideVolume</a>, with a
pressure that overshoots and swings after each change of the valve.</p>
</html>"));
end ResonantVolume;

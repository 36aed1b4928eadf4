within PneumaticMuscle.Effects.DeadVolume;
model ResonantVolume "Gas that takes no part in contraction, behind a neck whose gas has inertia"
  extends Chamber(final absent="V=1e-7, G=1e-7, I=1e3",
    G(min=1e-10, nominal=1e-8)=1e-8, UA=0.01);
  parameter Real I(unit="1/m", min=1e3, max=1e7, nominal=1e5) = 3e4 "Inertance: length of the neck by its section"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="SideVolume"));
  Types.MassFlowRate m_neck(start=0, nominal=1e-4) "Flow in the neck";
protected
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow over which the sides upstream blend";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    m_neck = 0;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(m_neck) = 0;
  end if;
equation
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

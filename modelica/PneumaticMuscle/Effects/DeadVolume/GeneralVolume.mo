within PneumaticMuscle.Effects.DeadVolume;
model GeneralVolume
  "Gas that takes no part in contraction, behind an opening, in a space that grows by any law of its pressure"
  extends FamilyMember(final general=true, final absent="V_0=1e-7, V_p=0, V_k=0, G=1e-7");
  parameter Types.Volume V_0(min=1e-7, max=1e-3, nominal=1e-5) = 1e-5 "Volume at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V_p(min=0, max=1e-3, nominal=1e-5) = 2e-6
    "Initial increase per 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=-0.9, max=1, nominal=0.3) = 0 "Exponent of the increase with the absolute pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V_k(min=0, max=1e-3, nominal=1e-5) = 1e-6 "Volume of a stroke between two pressures"
    annotation (Dialog(group="Effect"));
  parameter Types.GaugePressure p_k(min=0, max=5e5, nominal=5e4) = 5e4 "Pressure in the middle of the stroke"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure w_k(min=2e3, max=3e5, nominal=3e4) = 3e4 "Half of the pressure range of the stroke"
    annotation (Dialog(group="Effect"));
  parameter Real G(unit="kg/(s.Pa)", min=1e-11, max=1e-7, nominal=1e-9) = 5e-9
    "Conductance of the opening at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-0.6, max=0.5, nominal=0.2) = 0 "Exponent of the conductance, at a drop of 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="1", min=-1.5, max=1, nominal=0.3) = 0 "Exponent of the upstream pressure"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-2.5, max=2.5, nominal=0.3) = 0.1
    "Asymmetry of the logarithm of the conductance between filling and emptying"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance UA(min=0, max=50, nominal=0.02) = 0.01
    "Thermal conductance from the gas to ambient"
    annotation (Dialog(group="Effect"));
  Types.AbsolutePressure p_s(start=ambient.p) "Pressure in it";
  Types.Temperature T_s(start=ambient.T) "Temperature in it";
  Types.Mass m(nominal=1e-5) "Mass of the gas in it";
protected
  constant Types.Pressure p_reference = 1e5 "Pressure to which V_p refers";
  Real q(unit="1") = Functions.smoothMax((p_s - ambient.p)/p_reference, 2e-3)
    "Gauge pressure in it by the reference, not below zero";
  Types.Pressure beyond = p_s - ambient.p - p_k "Pressure beyond the middle of the stroke";
  Types.Volume V = V_0 + V_p*q*exp(n*log(1 + q)) + 0.5*V_k*(1 + beyond/sqrt(beyond^2 + w_k^2)) "Volume";
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
  V*der(p_s) + Constants.gamma*p_s*der(V) = (Constants.gamma - 1)*(port.H_flow - UA*(T_s - ambient.T));
  port.m_flow = Functions.curvedFlow(port.p, p_s, ambient.p, G, a, 0, c, asymmetry);
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, p_s, port.T, T_s);
  annotation (defaultComponentName="deadVolume", Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume.SideVolume\">SideVolume</a>, with V = V_0 + V_p q (1 +
q)^n + V_k/2 (1 + b/sqrt(b^2 + w_k^2)), q the gauge pressure in it by 100 kPa, b that beyond p_k, and the work p dV of
its growth; m_flow = G 100 kPa u |u|^a (p_up/p_atm)^c exp(asymmetry sgn u), u = (p^2 - p_s^2)/(2 p_atm 100 kPa). Source:
the balances <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53) and (59); a hose or a
bellows stretches in proportion to pressure at first, and less (n below 0) or more as it goes on; a piston on a spring
moves between its preload and its stop, as in an accumulator or a pressure switch; the opening is a power law, another
each way where a lip or a fold closes it, as in <a
href=\"modelica://PneumaticMuscle.Effects.SupplyLine.GeneralLine\">GeneralLine</a>. Typical as <a
href=\"modelica://PneumaticMuscle.Effects.DeadVolume.SideVolume\">SideVolume</a>, V_p a tenth of V_0 for a rubber
hose.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume.SideVolume\">SideVolume</a>, slower towards
the end of filling.</p>
</html>"));
end GeneralVolume;

within PneumaticMuscle.Effects.SupplyLine;
model SupplyDroop "A hose or a regulator before the inlet valve, behind which the pressure sags as gas flows"
  extends Interfaces.Feed;
  extends FamilyMember(final absent="D=0");
  parameter Types.Pressure D(min=0, max=3e5, nominal=1e4) = 1e4
    "Pressure loss at the reference flow and ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=0.3, max=2.5, nominal=1) = 1 "Exponent of the flow"
    annotation (Dialog(group="Effect"));
  parameter Real k(unit="1", min=-1.5, max=2, nominal=0.5) = 0 "Exponent of the absolute supply pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=1e-6, max=2, nominal=0.02) = 0.01 "Time constant of the pressure"
    annotation (Dialog(group="Effect"));
  Types.MassFlowRate m(start=0, fixed=dynamics == Types.Dynamics.FixedInitial, nominal=1e-4)
    "Flow that the pressure follows";
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow to which D refers";
  Types.Pressure lost = D*Functions.curvedPower(m/m_reference, n - 1, 0, 1e-3)*exp(k*log(max(port_a.p, 1.0)/ambient.p))
    "Pressure that is lost, as long as it is small";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(m) = 0;
  end if;
equation
  tau*der(m) = port_a.m_flow - m;
  port_b.p = port_a.p*exp(-lost/port_a.p);
  port_b.T = port_a.T;
  port_a.m_flow + port_b.m_flow = 0;
  port_a.H_flow + port_b.H_flow = 0;
  annotation (Documentation(info="<html>
<p>p_b = p_a exp(-d/p_a), d = D (m/0.1 g/s)^n (p_a/p_atm)^k, tau m_dot = m_flow - m, between the supply and the inlet
valve: a pressure that is lost with the flow, in a time of its own, and is never more than there is. Source: the droop
of a regulator, a curve of pressure by flow for every set pressure,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a> and data sheets, n near 1, k 0 to 1; a hose
loses by <a href=\"modelica://PneumaticMuscle.Laws.Lines.RoughTube\">RoughTube</a>'s law, n 1 to 2 and k = -1. The time
is that of the regulator's diaphragm, or of the hose, its volume by its conductance; p_supply is what is set or measured
before it. Typical D 1 to 30 kPa, tau 5 to 200 ms.</p>
<p>Fingerprint: filling is held back after a first burst, most where much flows; venting is right.</p>
</html>"));
end SupplyDroop;

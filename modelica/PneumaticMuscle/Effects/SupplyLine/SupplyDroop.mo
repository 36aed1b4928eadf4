within PneumaticMuscle.Effects.SupplyLine;
model SupplyDroop "A hose or a regulator before the inlet valve, behind which the pressure sags as gas flows"
  extends Interfaces.Feed;
  extends FamilyMember(final absent="G=1e-6, A=5e-6");
  parameter Real G(unit="kg/(s.Pa)", min=2e-10, max=1e-6, nominal=3e-9) = 1e-8 "Conductance of small flows at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 7e-7 "Effective area for large flows"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=1e-3, max=2, nominal=0.02) = 0.01 "Time in which the pressure follows the flow"
    annotation (Dialog(group="Effect"));
  Types.MassFlowRate m(start=0, fixed=true, nominal=1e-4) "Flow that the pressure follows";
protected
  outer Components.Ambient ambient "Surroundings";
  constant Types.Pressure p_least = 5e3 "Pressure below which what is left is rounded";
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow below which its size is rounded";
  Real left(unit="Pa2", nominal=1e10) = port_a.p^2 - 2*ambient.p/G*m - Constants.R*port_a.T/A^2*m*sqrt(m^2 + m_smooth^2)
    "Square of the pressure before the valve";
equation
  tau*der(m) = port_a.m_flow - m;
  port_b.p = sqrt(0.5*(left + sqrt(left^2 + p_least^4)));
  port_b.T = port_a.T;
  port_a.m_flow + port_b.m_flow = 0;
  port_a.H_flow + port_b.H_flow = 0;
  annotation (Documentation(info="<html>
<p>p_b^2 = p_a^2 - 2 p_atm/G m - R T/A^2 m |m|, tau m_dot = m_flow - m: a resistance as in FlexibleLine, between the supply and
the inlet valve, whose pressure follows the flow in a time of its own. Source: Forchheimer 1901 for the resistance; the pressure
that a regulator loses with the flow is stated as a curve of both by ISO 6358. The time is that of the regulator's
diaphragm, or of the hose, its volume by its conductance; p_supply is what is set or measured before it. Typical G and A as for
FlexibleLine, tau 5 to 200 ms.</p>
<p>Fingerprint: filling is held back after a first burst, most where much flows; venting is right.</p>
</html>"));
end SupplyDroop;

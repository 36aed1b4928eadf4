within PneumaticMuscle.Effects.SupplyLine;
model RegulatorDroop "The pressure of the supply sags in proportion to the flow"
  extends Interfaces.Feed;
  extends FamilyMember(final absent="D=0");
  parameter Types.Pressure D(min=0, max=3e5, nominal=1e4) = 1e4 "Pressure that is lost at the reference flow"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0, 3e4}));
  Types.MassFlowRate m(start=0, fixed=dynamics == Types.Dynamics.FixedInitial, nominal=1e-4)
    "Flow that the pressure follows";
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow to which D refers";
  constant Types.Time tau = 5e-3 "Time in which the regulator follows, as short as one can be";
  constant Types.Pressure p_least = 100 "Pressure that is left, however much flows";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(m) = 0;
  end if;
equation
  tau*der(m) = port_a.m_flow - m;
  port_b.p = p_least + Functions.smoothMax(port_a.p - D*m/m_reference - p_least, p_least);
  port_b.T = port_a.T;
  port_a.m_flow + port_b.m_flow = 0;
  port_a.H_flow + port_b.H_flow = 0;
  annotation (Documentation(info="<html>
<p>p_b = p_a - D m_flow/(0.1 g/s), between the supply and the inlet valve; a time of 5 ms keeps the flow a state.
Source: the flow characteristic of a regulator,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6953</a>, as a straight line; the same of a supply
behind a filter or a manifold. Typical 0 to 30 kPa: small regulators lose 20 to 100 kPa at 1 g/s.
<a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.SupplyDroop\">SupplyDroop</a> has other powers of the flow and a
time of its own.</p>
<p>Fingerprint: filling is held back, most where much flows; it ends at the right pressure; venting is right.</p>
</html>"));
end RegulatorDroop;

within PneumaticMuscle.Effects.SupplyLine;
model FlexibleLine "A tube between valves and muscle that is laminar at small and turbulent at large flow"
  extends Interfaces.Line;
  extends FamilyMember(final absent="G=1e-6, A=5e-6, V=2e-7");
  parameter Real G(unit="kg/(s.Pa)", min=2e-10, max=1e-6, nominal=3e-9) = 1e-8
    "Conductance of small flows at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 4e-7 "Effective area for large flows"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 2e-6 "Volume of the tube, at the valve end"
    annotation (Dialog(group="Effect"));
protected
  Laws.Lines.LineGas gas(V=V, p(start=ambient.p), T(start=ambient.T)) "Gas in the line, at the valve end"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Laws.Lines.RoughTube resistance(G=G, A=A) "Tube"
    annotation (Placement(transformation(extent={{10,-20},{50,20}})));
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    gas.p = port_b.p;
    gas.T = port_b.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(gas.p) = 0;
    der(gas.m) = 0;
  end if;
equation
  connect(port_a, gas.port)
    annotation (Line(points={{-100,0}, {-45,0}, {-45,50}, {-40,50}}, color={0,90,160}));
  connect(gas.port, resistance.port_a)
    annotation (Line(points={{-40,50}, {-45,50}, {-45,0}, {10,0}}, color={0,90,160}));
  connect(resistance.port_b, port_b)
    annotation (Line(points={{50,0}, {100,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>p_a^2 - p_b^2 = 2 p_atm/G m_flow + R T/A^2 m_flow |m_flow|,
<a href=\"modelica://PneumaticMuscle.Laws.Lines.RoughTube\">Laws.Lines.RoughTube</a>. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Forchheimer 1901</a>, for isothermal flow of an ideal gas.
With a large A it is <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.LaminarLine\">LaminarLine</a>, with a large
G the elliptic law that <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a> gives long tubes; the
isentropic orifice, choked or not, is met within 9 %, with a laminar tube in series within 7 %, Blasius' law within 4 %.
Typical as for <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.LaminarLine\">LaminarLine</a> and
<a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.LongLine\">LongLine</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.LongLine\">LongLine</a>.</p>
</html>"));
end FlexibleLine;

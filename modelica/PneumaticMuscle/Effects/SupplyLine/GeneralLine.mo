within PneumaticMuscle.Effects.SupplyLine;
model GeneralLine
  "A tube between valves and muscle whose flow is any smooth law of the pressures, "
  + "another each way, in a hose that may widen, and whose gas may cool"
  extends Interfaces.Line;
  extends FamilyMember(final general=true, final absent="G=1e-6, V=2e-7, UA=0");
  parameter Real G(unit="kg/(s.Pa)", min=2e-10, max=1e-6, nominal=3e-9) = 1e-8
    "Conductance at the reference drop, at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-0.6, max=0.5, nominal=0.2) = -0.2 "Exponent of the conductance at the reference drop"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.1, max=0.1, nominal=0.03) = 0
    "Quadratic coefficient of the exponent, by the logarithm of the drop"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="1", min=-1, max=1, nominal=0.3) = 0 "Exponent of the pressure upstream"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-2, max=2, nominal=0.3) = 0.1
    "Asymmetry of the logarithm of the conductance between filling and venting"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 2e-6 "Volume of the tube, at the valve end"
    annotation (Dialog(group="Effect"));
  parameter Real expansion(unit="1/Pa", min=0, max=9e-6, nominal=2e-6) = 0
    "Relative growth of its volume by the gauge pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance UA(min=0, max=2, nominal=0.02) = 0.01
    "Conductance from its gas to the surroundings"
    annotation (Dialog(group="Effect"));
protected
  Laws.Lines.LineGas gas(V=V, expansion=expansion, UA=UA, p(start=ambient.p), T(start=ambient.T))
    "Gas in the line, at the valve end"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Laws.Lines.CurvedTube resistance(G=G, a=a, b=b, c=c, asymmetry=asymmetry) "Tube"
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
<p>m_flow = G 100 kPa u |u|^(a + b ln|u|) (p_up/p_atm)^c exp(asymmetry sgn u), u = (p_a^2 - p_b^2)/(2 p_atm 100 kPa), <a
href=\"modelica://PneumaticMuscle.Laws.Lines.CurvedTube\">Laws.Lines.CurvedTube</a>. Source: the power laws of tubes
(a = 0 laminar, Hagen and Poiseuille; -3/7 Blasius; -1/2 rough tubes and orifices), with one more term in the
logarithm of the drop; a check valve beside a throttle makes the two ways differ. The gas in it fills V (1 + expansion
p_gauge) and gives UA (T - T_atm) to the surroundings; with a large UA it has their temperature, as in <a
href=\"modelica://PneumaticMuscle.Effects.SupplyLine.FrictionLine\">FrictionLine</a>. The isentropic orifice, choked
or not, is met within 4 %. Typical G 1e-9 to 1e-8 kg/(s.Pa), a -0.5 to 0, asymmetry -0.5 to 0.5, expansion 0 for a rigid
tube and 1e-6 to 6e-6 1/Pa for a rubber hose; below 1/p_atm, so that a vacuum leaves it a volume.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.FlexibleLine\">FlexibleLine</a>, or filling
and venting are held back unequally.</p>
</html>"));
end GeneralLine;

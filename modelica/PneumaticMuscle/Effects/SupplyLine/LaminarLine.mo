within PneumaticMuscle.Effects.SupplyLine;
model LaminarLine "A thin tube between valves and muscle"
  extends Interfaces.Line;
  extends FamilyMember(final absent="G=1e-6");
  parameter Real G(unit="kg/(s.Pa)", min=2e-10, max=1e-6, nominal=3e-9) = 3e-9 "Conductance at ambient pressure"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Volume V_fitting = 2e-7 "Volume between valve and line, as small as a fitting can be";
  Laws.Lines.LineGas gas(V=V_fitting, p(start=ambient.p), T(start=ambient.T)) "Gas in the line, at the valve end"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Laws.Lines.LaminarTube resistance(G=G) "Tube"
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
<p>m_flow = G (p_a^2 - p_b^2)/(2 p_atm): isothermal laminar flow of a gas through a tube, G = pi d^4
rho_atm/(128 mu l). Source: Hagen and Poiseuille with the density of an ideal gas. A fitting's volume of 0.2 mL
keeps the pressure at the valve a state. Typical: 1 m of 1.5 mm tube 8e-9, of 1 mm tube 1.6e-9 kg/(s.Pa); at
1e-6 it is not felt.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.OrificeLine\">OrificeLine</a>; it throttles
least at high pressure and most near ambient pressure.</p>
</html>"));
end LaminarLine;

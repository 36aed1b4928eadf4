within PneumaticMuscle.Effects.SupplyLine;
model HoseLine "A hose of 4 mm bore between valves and muscle"
  extends Interfaces.Line;
  extends FamilyMember(final absent="V=2e-7");
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 1e-5 "Volume of the hose, at the valve end"
    annotation (Dialog(group="Effect"), __PamCosim(typical={1e-6, 4e-5}));
protected
  constant Types.Length d = 4e-3 "Bore";
  constant Types.Area A_bore = Constants.pi*d^2/4 "Section of the bore";
  constant Real friction = 0.03 "Darcy's friction factor";
  constant Real ends = 1.5 "Loss of entrance and exit, by the dynamic pressure";
  Laws.Lines.LineGas gas(V=V, p(start=ambient.p), T(start=ambient.T)) "Gas in the line, at the valve end"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Laws.Lines.TurbulentTube resistance(A=A_bore/sqrt(ends + friction*V/(A_bore*d))) "Friction of the wall"
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
<p>A hose of the length l = V/(pi d^2/4), d = 4 mm: its volume V behind the valves, and m_flow = A sqrt((p_a^2 -
p_b^2)/(R T_atm)) with A = (pi d^2/4)/sqrt(1.5 + f l/d), f = 0.03,
<a href=\"modelica://PneumaticMuscle.Laws.Lines.TurbulentTube\">Laws.Lines.TurbulentTube</a>. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Shapiro 1953</a>; one lump as in
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a>. Typical 0.1 to 3 m, 1 to 40 mL; 0.2 mL is
a fitting. A hose of another bore is <a
href=\"modelica://PneumaticMuscle.Effects.SupplyLine.LongLine\">LongLine</a>, whose resistance is a parameter of its
own.</p>
<p>Fingerprint: filling and venting are slower, most while the muscle is long and its own volume small, as behind
<a href=\"modelica://PneumaticMuscle.Effects.DeadVolume\">DeadVolume</a>; the pressure in the muscle goes on rising
for a moment after the inlet valve has shut.</p>
</html>"));
end HoseLine;

within PneumaticMuscle.Effects.SupplyLine;
model FrictionLine "A long tube with wall friction and the temperature of its surroundings"
  extends Interfaces.Line;
  extends FamilyMember;
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 3e-7 "Effective area of the tube"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 1e-5 "Volume of the tube, at the valve end"
    annotation (Dialog(group="Effect"));
protected
  Laws.Lines.TubeGas gas(V=V, p(start=ambient.p)) "Gas in the tube"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Laws.Lines.TurbulentTube resistance(A=A) "Friction of the wall"
    annotation (Placement(transformation(extent={{10,-20},{50,20}})));
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    gas.p = port_b.p;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(gas.p) = 0;
  end if;
equation
  connect(port_a, gas.port)
    annotation (Line(points={{-100,0}, {-45,0}, {-45,50}, {-40,50}}, color={0,90,160}));
  connect(gas.port, resistance.port_a)
    annotation (Line(points={{-40,50}, {-45,50}, {-45,0}, {10,0}}, color={0,90,160}));
  connect(resistance.port_b, port_b)
    annotation (Line(points={{50,0}, {100,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>m_flow = A sqrt((p_a^2 - p_b^2)/(R T)), isothermal turbulent flow through a long tube behind its volume.
A = (pi d^2/4)/sqrt(f l/d) with Darcy's friction factor f, where the logarithm of the pressures is small compared with
f l/d. Source: isothermal flow in long ducts, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Shapiro 1953</a>.
Typical f 0.02 to 0.04: 2 m of 4 mm tube 3e-6 m2 and 25 mL. The volume at the muscle's end is
<a href=\"modelica://PneumaticMuscle.Effects.DeadVolume\">DeadVolume</a>. What is vented reaches the valve at ambient
temperature, so that no value of A and V quite gives the base law back.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.LongLine\">LongLine</a>, but the flow never
chokes: it falls from the beginning as the pressure at the muscle rises.</p>
</html>"));
end FrictionLine;

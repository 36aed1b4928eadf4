within PneumaticMuscle.Effects.SupplyLine;
model LongLine "A tube of its own volume and resistance between valves and muscle"
  extends Interfaces.Line;
  extends FamilyMember(final absent="A=5e-6, V=2e-7");
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 3e-7 "Effective area of the tube"
    annotation (Dialog(group="Effect"), __PamCosim(at_max="HoseLine"));
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 1e-5 "Volume of the tube, at the valve end"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="OrificeLine"));
protected
  Laws.Lines.LineGas gas(V=V, p(start=ambient.p), T(start=ambient.T)) "Gas in the line, at the valve end"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Pneumatics.Components.Orifice resistance(A=A) "Resistance of the tube"
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
<p>As <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.OrificeLine\">OrificeLine</a>, with the volume of the
tube. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Woods and others 2014</a>, discussed after
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12), for losses along supply lines; one lump as in
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a>. Typical: 1 m of 4 mm tube 12 mL. The volume
at the muscle's end is <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume\">DeadVolume</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.SupplyLine.OrificeLine\">OrificeLine</a>; the pressure
in the muscle goes on rising a little after the inlet valve has shut, and goes on falling after the exhaust valve has
shut.</p>
</html>"));
end LongLine;

within PneumaticMuscle.Effects.SupplyLine;
model LongLine "A tube of its own volume and resistance between valves and muscle"
  extends Interfaces.Line;
  extends FamilyMember(final absent="A=5e-6, V=2e-7");
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 3e-7 "Effective area of the tube"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 1e-5 "Volume of the tube, at the valve end"
    annotation (Dialog(group="Effect"));
protected
  Laws.Lines.LineGas gas(V=V, p(start=ambient.p), T(start=ambient.T)) "Gas in the line, at the valve end";
  Components.Orifice resistance(A=A) "Resistance of the tube";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    gas.p = port_b.p;
    gas.T = port_b.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(gas.p) = 0;
    der(gas.m) = 0;
  end if;
equation
  connect(port_a, gas.port);
  connect(gas.port, resistance.port_a);
  connect(resistance.port_b, port_b);
  annotation (Documentation(info="<html>
<p>As OrificeLine, with the volume of the tube. Source: Woods and others 2014, discussed after DP
(12), for losses along supply lines; one lump as in ISO 6358. Typical: 1 m of 4 mm tube 12 mL. The volume at the
muscle's end is DeadVolume.</p>
<p>Fingerprint: as OrificeLine; the pressure in the muscle goes on rising a little after the inlet valve has
shut, and goes on falling after the exhaust valve has shut.</p>
</html>"));
end LongLine;

within PneumaticMuscle.Effects.SupplyLine;
model FrictionLine "A long tube with wall friction and the temperature of its surroundings"
  extends Interfaces.Line;
  extends FamilyMember;
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 3e-7 "Effective area of the tube"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V(min=2e-7, max=5e-4, nominal=1e-5) = 1e-5 "Volume of the tube, at the valve end"
    annotation (Dialog(group="Effect"));
protected
  Laws.Lines.TubeGas gas(V=V, p(start=ambient.p)) "Gas in the tube";
  Laws.Lines.TurbulentTube resistance(A=A) "Friction of the wall";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    gas.p = port_b.p;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(gas.p) = 0;
  end if;
equation
  connect(port_a, gas.port);
  connect(gas.port, resistance.port_a);
  connect(resistance.port_b, port_b);
  annotation (Documentation(info="<html>
<p>m_flow = A sqrt((p_a^2 - p_b^2)/(R T)), isothermal turbulent flow through a long tube behind its volume.
A = (pi d^2/4)/sqrt(f l/d) with Darcy's friction factor f, where the logarithm of the pressures is small beside f l/d.
Source: isothermal flow in long ducts, Shapiro 1953.
Typical f 0.02 to 0.04: 2 m of 4 mm tube 3e-6 m2 and 25 mL. The volume at the muscle's end is DeadVolume.
What is vented reaches the valve at ambient temperature, so that no value of A and V quite gives the base law back.</p>
<p>Fingerprint: as LongLine, but the flow never chokes: it falls from the beginning as the pressure at the muscle
rises.</p>
</html>"));
end FrictionLine;

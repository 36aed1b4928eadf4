within PneumaticMuscle.Effects.Leak;
model LaminarLeak "Gas seeps out in proportion to the gauge pressure"
  extends FamilyMember(final absent="G=0");
  parameter Real G(unit="kg/(s.Pa)", min=0, max=1e-9, nominal=1e-11) = 1e-11 "Conductance"
    annotation (Dialog(group="Effect"));
equation
  port.m_flow = G*(port.p - ambient.p);
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G p_gauge: laminar flow through pores and threads. Source: Hagen and Poiseuille. Typical 1e-12 to
1e-10 kg/(s.Pa); 1e-9 lets 10 litres of free air a minute pass at 200 kPa, as much as an open valve of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>, and is not called a leak any more.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.OrificeLeak\">OrificeLeak</a>, in proportion to the
gauge pressure instead of choked.</p>
</html>"));
end LaminarLeak;

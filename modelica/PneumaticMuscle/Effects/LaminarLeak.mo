within PneumaticMuscle.Effects;
model LaminarLeak "Gas seeps out in proportion to the gauge pressure"
  extends Interfaces.GasPortEffect(final family="leak");
  parameter Real G(unit="kg/(s.Pa)", min=0, max=1e-8, nominal=1e-11) = 1e-11 "Conductance";
equation
  port.m_flow = G*(port.p - ambient.p);
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G p_gauge: laminar flow through pores and threads.</p>
<p>Fingerprint: as OrificeLeak, in proportion to the gauge pressure instead of choked.</p>
</html>"));
end LaminarLeak;

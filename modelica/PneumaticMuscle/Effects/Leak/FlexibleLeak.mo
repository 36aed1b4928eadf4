within PneumaticMuscle.Effects.Leak;
model FlexibleLeak "Gas escapes by any smooth law of the gauge pressure"
  extends SmoothLeak;
equation
  over = q;
  further = 0;
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G p_gauge |q|^(a + b ln|q|) exp(g (q - 1)), q = p_gauge/100 kPa. Source: as
<a href=\"modelica://PneumaticMuscle.Effects.Leak.SmoothLeak\">SmoothLeak</a>, whose law it is. Up to 250 kPa it is,
with g = 0, within 2 % of laminar, orifice, square-root, square, cubic and compressible laminar leaks and of their sums,
and within 3 to 9 % of one that opens at a threshold of 50 to 100 kPa. Typical G 1e-12 to 1e-10 kg/(s.Pa), a -0.5 to 1,
b 0, g -1 to 0.5.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.OrificeLeak\">OrificeLeak</a>, by another law of
pressure.</p>
</html>"));
end FlexibleLeak;

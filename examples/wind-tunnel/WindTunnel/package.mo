package WindTunnel "A small wind tunnel with an intake fan, an exhaust fan and a hatch, and what its published models leave out"
  annotation (version="1.0.0", Documentation(info="<html>
<p>The base model has the models A2 (speed), B1 (current) and C3 (pressure) of J. L. Gamella, J. Peters, P. Bühlmann, <i>Causal
chambers as a real-world physical testbed for AI methodology</i>, Nature Machine Intelligence, 2025, appendix IV
(arXiv:2404.11341), with the values of the authors. SI units throughout.</p>
</html>"));
end WindTunnel;

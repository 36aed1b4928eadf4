within WindTunnel.Components;
model Chamber "Static pressure between the fans"
  input Real w_in(unit="rad/s") "Speed of the intake fan";
  input Real w_out(unit="rad/s") "Speed of the exhaust fan";
  outer Air air "Hatch";
  parameter Real S_max(unit="Pa", min=0, max=1e4) = 74.82 "Static pressure of a fan at full speed without flow, data sheet";
  parameter Real w_max(unit="rad/s", min=1, max=1e4) = 314.16 "Full speed, data sheet";
  parameter Real r_0(unit="1", min=0.01, max=0.99) = 0.75 "Flow with the hatch shut over flow without resistance";
  parameter Real beta(unit="1", min=0, max=1) = 0.15 "What the open hatch adds to that";
  Real p(unit="Pa") "Static pressure, above that of the surroundings";
protected
  Real r(unit="1") "Flow over flow without resistance";
equation
  r = r_0 + beta*air.hatch;
  p = S_max*(1 - r)*(w_in*abs(w_in) - w_out*abs(w_out))/w_max^2;
  annotation (Documentation(info="<html><p>Model C3 of Gamella and others, 2025: where a resistance Z Q² meets the linear characteristic of a
fan. With Z = S_max (1 - r)/(r Q_max)² they meet at the flow r Q_max and the pressure (1 - r) S_max, at full speed; at other
speeds both follow the affinity laws.</p></html>"));
end Chamber;

within WindTunnel.Effects;
model PowerMotors "The current gives the power, not the torque, because the supply has a constant voltage"
  extends Interfaces.Motors;
  extends Interfaces.Effect(final family="motor_torque", final balance="torque");
  parameter Real w_0(unit="rad/s", min=1, max=300, nominal=30) = 30 "Speed below which the torque grows no further";
protected
  constant Real w_max(unit="rad/s") = 314.16 "Full speed, data sheet, at which the torque is tau_max";
equation
  tau_in = tau_max*L_in^3*w_max/sqrt(w_in^2 + w_0^2);
  tau_out = tau_max*L_out^3*w_max/sqrt(w_out^2 + w_0^2);
  annotation (Documentation(info="<html>
<p>tau w = P_max L³: balance of energy of a motor behind a converter, supplied at a constant voltage with the current of model B1 of
Gamella and others, 2025; the torque is limited at rest. Source: A. E. Fitzgerald, C. Kingsley, S. D. Umans, <i>Electric
Machinery</i>, 6th ed., section 1.</p>
<p>Fingerprint: speed goes with the load, and a fan starts with more torque than it runs with.</p>
</html>"));
end PowerMotors;

within WindTunnel.Effects;
model DirectCurrentMotors "The motors induce a voltage, and a bridge of one direction does not brake"
  extends Interfaces.Motors;
  extends Interfaces.Effect(final family="motor_torque", final balance="torque");
  parameter Real w_0(unit="rad/s", min=100, max=5000, nominal=300) = 400 "Speed at which the induced voltage is that of full load";
protected
  constant Real L_s(unit="1") = 0.02 "Load over which the bridge stops to conduct";
equation
  tau_in = tau_max*0.5*((L_in - w_in/w_0) + sqrt((L_in - w_in/w_0)^2 + L_s^2) - L_s);
  tau_out = tau_max*0.5*((L_out - w_out/w_0) + sqrt((L_out - w_out/w_0)^2 + L_s^2) - L_s);
  annotation (Documentation(info="<html>
<p>tau = tau_max max(L - w/w_0, 0), rounded at zero: k (u - k w)/R with a voltage u in proportion to the load. Source: A. E. Fitzgerald,
C. Kingsley, S. D. Umans, <i>Electric Machinery</i>, 6th ed., section 7.</p>
<p>Fingerprint: torque falls while a fan speeds up; speed goes with the load also at small loads.</p>
</html>"));
end DirectCurrentMotors;

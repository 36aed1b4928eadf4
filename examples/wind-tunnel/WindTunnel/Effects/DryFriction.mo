within WindTunnel.Effects;
model DryFriction "Dry friction of the bearings"
  extends Interfaces.TorqueEffect(final family="dry_friction", final absent="tau_C=0");
  parameter Real tau_C(unit="N.m", min=0, max=1e-2, nominal=1e-4) = 1e-4 "Friction torque";
  parameter Real w_s(unit="rad/s") = 2 "Speed over which it turns round; without bounds, so that no fit moves it";
equation
  tau_in = tau_C*tanh(w_in/w_s);
  tau_out = tau_C*tanh(w_out/w_s);
  annotation (Documentation(info="<html>
<p>tau = tau_C tanh(w/w_s). Source: C. A. Coulomb, <i>Théorie des machines simples</i>, 1785, smoothed at rest.</p>
<p>Fingerprint: a fan that is left to itself slows down at a steady rate at the end.</p>
</html>"));
end DryFriction;

within DCMotor.Effects;
model CoulombFriction "Dry friction of bearings and brushes"
  extends Interfaces.TorqueEffect(final family="dry_friction", final absent="tau_C=0");
  parameter Real tau_C(unit="N.m", min=0, max=0.2, nominal=0.01) = 0.005 "Friction torque";
  parameter Real w_s(unit="rad/s") = 0.5 "Speed over which it turns round; without bounds, so that no fit moves it";
equation
  tau = tau_C*tanh(w/w_s);
  annotation (Documentation(info="<html>
<p>tau = tau_C tanh(w/w_s). Source: C. A. Coulomb, <i>Théorie des machines simples</i>, 1785, smoothed at rest.</p>
<p>Fingerprint: the current at a steady speed has a part that does not grow with the speed.</p>
</html>"));
end CoulombFriction;

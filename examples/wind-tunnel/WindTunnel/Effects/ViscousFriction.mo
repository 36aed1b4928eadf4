within WindTunnel.Effects;
model ViscousFriction "Friction of the lubricant, and eddy currents"
  extends Interfaces.TorqueEffect(final family="viscous_friction", final absent="b=0");
  parameter Real b(unit="N.m.s/rad", min=0, max=1e-3, nominal=1e-5) = 1e-6 "Torque over speed";
equation
  tau_in = b*w_in;
  tau_out = b*w_out;
  annotation (Documentation(info="<html>
<p>tau = b w. Source: A. E. Fitzgerald, C. Kingsley, S. D. Umans, <i>Electric Machinery</i>, 6th ed., section 7.</p>
<p>Fingerprint: a fan that is left to itself slows down exponentially at the end, not hyperbolically.</p>
</html>"));
end ViscousFriction;

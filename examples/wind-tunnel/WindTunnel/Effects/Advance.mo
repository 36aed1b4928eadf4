within WindTunnel.Effects;
model Advance "Air that one fan moves drives the other, and relieves it the faster it turns"
  extends Interfaces.TorqueEffect(final family="windmill", final absent="E=0, D=0");
  parameter Real E(unit="N.m.s2/rad2", min=0, max=1e-3, nominal=1e-8) = 5e-9 "Driving torque over the square of the other fan's speed";
  parameter Real D(unit="N.m.s2/rad2", min=-1e-3, max=1e-3, nominal=1e-8) = 1e-9 "Driving torque over the product of both speeds";
equation
  tau_in = -E*w_out*abs(w_out) - D*w_in*w_out;
  tau_out = -E*w_in*abs(w_in) - D*w_in*w_out;
  annotation (Documentation(info="<html>
<p>tau = -E v² - D v w: blade elements in the flow of the other fan; the torque of a propeller, K w² - D v w - E v², is a quadratic form
of its own speed and that of the air where lift is linear in the angle of attack. Source: H. Glauert, <i>Airplane Propellers</i>, 1935.</p>
<p>Fingerprint: as Windmill, and two fans that run together are faster than one.</p>
</html>"));
end Advance;

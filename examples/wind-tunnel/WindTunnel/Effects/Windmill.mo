within WindTunnel.Effects;
model Windmill "The air that one fan moves drives the other"
  extends Interfaces.TorqueEffect(final family="windmill", final absent="E=0");
  parameter Real E(unit="N.m.s2/rad2", min=0, max=1e-3, nominal=1e-8) = 5e-9 "Driving torque over the square of the other fan's speed";
equation
  tau_in = -E*w_out*abs(w_out);
  tau_out = -E*w_in*abs(w_in);
  annotation (Documentation(info="<html>
<p>tau = -E v², v the speed of the air, in proportion to the speed of the fan that moves it. Source: H. Glauert, <i>Airplane
Propellers</i>, in: W. F. Durand, Aerodynamic Theory IV, 1935: the torque of a propeller at a given advance ratio goes with the
square of the speed; affinity laws for the other fan.</p>
<p>Fingerprint: a fan that idles turns faster while the other one runs.</p>
</html>"));
end Windmill;

within WindTunnel.Effects;
model SquareMotors "Torque goes with the square of the load"
  extends Interfaces.Motors;
  extends Interfaces.Effect(final family="motor_torque", final balance="torque");
equation
  tau_in = tau_max*L_in^2;
  tau_out = tau_max*L_out^2;
  annotation (Documentation(info="<html>
<p>tau = tau_max L²: power with the cube of the load, speed with the load. Source: affinity laws of fans, with models A1 and B1 of
Gamella and others, 2025.</p>
</html>"));
end SquareMotors;

within WindTunnel.Components;
model CubicMotors "Torque in proportion to the current beyond that of idling, which goes with the cube of the load"
  extends Interfaces.Motors;
equation
  tau_in = tau_max*L_in^3;
  tau_out = tau_max*L_out^3;
  annotation (Documentation(info="<html><p>Models A2 and B1 of Gamella and others, 2025.</p></html>"));
end CubicMotors;

within WindTunnel.Interfaces;
partial model Motors "Torque of both motors; left open: the equations of tau_in and tau_out"
  input Real L_in(unit="1") "Load of the intake fan, at least the least one; 0: off";
  input Real L_out(unit="1") "Load of the exhaust fan, at least the least one; 0: off";
  input Real w_in(unit="rad/s") "Speed of the intake fan";
  input Real w_out(unit="rad/s") "Speed of the exhaust fan";
  parameter Real tau_max(unit="N.m", min=0) "Torque at full load";
  Real tau_in(unit="N.m") "Torque of the intake fan's motor";
  Real tau_out(unit="N.m") "Torque of the exhaust fan's motor";
end Motors;

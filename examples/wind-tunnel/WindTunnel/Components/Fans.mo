within WindTunnel.Components;
model Fans "Two equal fans: torque of the motors, and drag of the air"
  extends Interfaces.FanTerminals;
  input Real u_in(unit="1") "Commanded load of the intake fan";
  input Real u_out(unit="1") "Commanded load of the exhaust fan";
  parameter Real tau_max(unit="N.m", min=0, max=1, nominal=1e-3) = 5.2e-3 "Torque at full load; the authors': 0.05 N.m/A times 104 mA";
  parameter Real K(unit="N.m.s2/rad2", min=0, max=1e-3, nominal=1e-8) = 5.27e-8 "Drag over the square of the speed";
  parameter Real L_min(unit="1", min=0, max=1) = 0.1 "Least load that the electronics of a fan give their motor";
  parameter Real C_min(unit="A", min=0, max=10) = 0.166 "Current without load; the authors'";
  parameter Real C_max(unit="A", min=0, max=10, nominal=0.1) = 0.27 "Current at full load; the authors'";
  Real i_in(unit="A") "Current of the intake fan";
  Real i_out(unit="A") "Current of the exhaust fan";
  replaceable model Drive = DirectDrive constrainedby Interfaces.Drive "From commands to loads" annotation (choicesAllMatching=true);
  replaceable model Motors = CubicMotors constrainedby Interfaces.Motors "Torque" annotation (choicesAllMatching=true);
  Drive drive(u_in=if u_in > 0 then max(u_in, L_min) else 0, u_out=if u_out > 0 then max(u_out, L_min) else 0) "Electronics";
  Motors motors(tau_max=tau_max, L_in=drive.L_in, L_out=drive.L_out, w_in=intake.w, w_out=exhaust.w) "Motors";
equation
  intake.tau = K*intake.w*abs(intake.w) - motors.tau_in;
  i_in = C_min + (C_max - C_min)*drive.L_in^3;
  i_out = C_min + (C_max - C_min)*drive.L_out^3;
  exhaust.tau = K*exhaust.w*abs(exhaust.w) - motors.tau_out;
  annotation (Documentation(info="<html><p>Models A2, I der(w) = tau(L) - K w², and B1, i = C_min + (C_max - C_min) L³,
of Gamella and others, 2025.</p></html>"));
end Fans;

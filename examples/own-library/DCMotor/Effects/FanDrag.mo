within DCMotor.Effects;
model FanDrag "Drag of the air, such as of a fan on the shaft"
  extends Interfaces.TorqueEffect(final family="air_drag", final absent="c=0");
  parameter Real c(unit="N.m.s2/rad2", min=0, max=1e-3, nominal=1e-6) = 1e-7 "Torque over the square of the speed";
equation
  tau = c*w*abs(w);
  annotation (Documentation(info="<html>
<p>tau = c w |w|. Source: the affinity laws of fans.</p>
<p>Fingerprint: the current grows with the square of the speed.</p>
</html>"));
end FanDrag;

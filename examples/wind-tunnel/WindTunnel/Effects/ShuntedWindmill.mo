within WindTunnel.Effects;
model ShuntedWindmill "The air that one fan moves drives the other; an open hatch lets a part of it past"
  extends Interfaces.TorqueEffect(final family="windmill", final absent="E=0");
  parameter Real E(unit="N.m.s2/rad2", min=0, max=1e-3, nominal=1e-8) = 5e-9 "Driving torque over the square of the other fan's speed";
  parameter Real s(unit="1", min=0, max=1) = 0.3 "Share of the air that leaves or enters by the open hatch";
protected
  Real passed(unit="1") "Share of the air that goes through both fans";
equation
  passed = 1 - s*air.hatch;
  tau_in = -E*passed^2*w_out*abs(w_out);
  tau_out = -E*passed^2*w_in*abs(w_in);
  annotation (Documentation(info="<html>
<p>tau = -E v², where v falls with the opening of the hatch by continuity. Source: as Windmill.</p>
<p>Fingerprint: as Windmill, and less so while the hatch is open.</p>
</html>"));
end ShuntedWindmill;

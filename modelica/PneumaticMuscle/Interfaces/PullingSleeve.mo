within PneumaticMuscle.Interfaces;
partial model PullingSleeve "A cylinder whose pull is what a law gives, where that is a pull"
  extends Cylinder;
  Real eps(unit="1") = 1 - L/L0 "Contraction ratio";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Types.Force F_law "What the law gives";
protected
  constant Types.Force F_smooth = 0.1 "Force over which the pull ends";
equation
  F = Functions.slackMax(F_law, F_smooth);
  annotation (Documentation(info="<html>
<p>A muscle goes slack where it would have to push: F = max(0, F_law), rounded over 0.1 N. Left to the extending class:
F_law.</p>
</html>"));
end PullingSleeve;

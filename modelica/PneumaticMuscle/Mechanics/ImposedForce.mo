within PneumaticMuscle.Mechanics;
model ImposedForce "A drive that imposes the force at the load end"
  extends Interfaces.Mechanics(shows="x", F_start=30);
  extends Components.SlidingMass(m=0.5, final s_start=x_start);
  extends Icons.Motion;
  Interfaces.Signals.ForceInput F_load(start=30) "Imposed force, positive in pull"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.TranslationalDamping d(min=0, max=1e4) = 20 "Damping of the guide"
    annotation (Dialog(group="Mechanics"));
equation
  f_back = F_load + d*v;
  annotation (defaultComponentName="drive", Documentation(info="<html>
<p>m x_ddot = F - F_load - d x_dot, Newton's law of the end of the muscle with what is fixed to it. F_start is the force
at the start, at which the muscle hangs without pressure. Values are for illustration.</p>
</html>"));
end ImposedForce;

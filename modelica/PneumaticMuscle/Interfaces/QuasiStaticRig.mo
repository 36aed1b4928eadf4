within PneumaticMuscle.Interfaces;
partial model QuasiStaticRig "What stands around the parts of a rig that is measured at rest, point by point"
  extends Rig(ambient(branch=branch));
  Interfaces.Signals.RealInput branch(start=0, unit="1", min=-1, max=1)
    "Direction of the branch: 1 contraction, -1 extension, 0 not known"
    annotation (Placement(transformation(extent={{-200,70},{-180,90}}),
      iconTransformation(extent={{-110,65},{-90,85}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Interfaces.Rig\">Rig</a>. Between points at rest the muscle has moved one way
or the other: the sign of dry friction is that of the branch. Where the direction is not known friction has no sign and
is left out, as in the mean of both branches.</p>
</html>"));
end QuasiStaticRig;

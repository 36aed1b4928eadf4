within PneumaticMuscle.Interfaces;
partial model QuasiStaticLoadedRig
  "What stands around a rig measured at rest whose muscle must know the load of the run"
  extends LoadedRig(ambient(branch=branch));
  Interfaces.Signals.RealInput branch(start=0, unit="1", min=-1, max=1)
    "Direction of the branch: 1 contraction, -1 extension, 0 not known"
    annotation (Placement(transformation(extent={{-200,70},{-180,90}}),
      iconTransformation(extent={{-110,65},{-90,85}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Interfaces.LoadedRig\">LoadedRig</a> for points at rest, as
<a href=\"modelica://PneumaticMuscle.Interfaces.QuasiStaticRig\">QuasiStaticRig</a>. Friction that goes with the
frequency is zero.</p>
</html>"));
end QuasiStaticLoadedRig;

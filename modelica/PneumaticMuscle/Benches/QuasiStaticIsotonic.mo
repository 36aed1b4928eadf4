within PneumaticMuscle.Benches;
model QuasiStaticIsotonic "Contraction of a muscle at rest under an imposed pressure and an imposed load"
  extends Interfaces.QuasiStaticRig;
  extends BaseClasses.PressurisedMuscle(muscle(F_start=drive.F_start));
  Interfaces.Signals.ForceInput F(start=30) "Imposed load"
    annotation (Placement(transformation(extent={{-200,-100},{-180,-80}}),
      iconTransformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.LengthOutput x "Contraction"
    annotation (Placement(transformation(extent={{150,-40},{170,-20}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Mechanics.ImposedForce drive(x_start=muscle.x_start) "The load"
    annotation (Placement(transformation(extent={{30,-160},{70,-120}})));
  Instruments.Position position "Displacement transducer"
    annotation (Placement(transformation(extent={{100,-60},{140,-20}})));
equation
  connect(muscle.flange_a, position.flange)
    annotation (Line(points={{50,-20}, {50,-40}, {100,-40}}, color={0,110,60}));
  connect(muscle.flange_a, drive.flange)
    annotation (Line(points={{50,-20}, {50,-120}}, color={0,110,60}));
  connect(F, drive.F_load)
    annotation (Line(points={{-190,-90}, {25,-90}, {25,-140}, {30,-140}}, color={0,0,127}));
  connect(position.x, x)
    annotation (Line(points={{140,-40}, {155,-40}, {155,-30}, {160,-30}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{160,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Isotonic curves and loops: each row is a point at rest, data sets say <code>kind = &quot;static&quot;</code>. The
contraction at which the pull carries the load is solved for, with der = 0 in
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17), (68)-(71); the fibre friction DP (69) vanishes
with the speed. <code>branch</code> gives dry friction its sign, so that an up branch and a down branch differ by twice
the friction.</p>
</html>"));
end QuasiStaticIsotonic;

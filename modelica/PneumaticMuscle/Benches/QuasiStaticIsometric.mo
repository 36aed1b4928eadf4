within PneumaticMuscle.Benches;
model QuasiStaticIsometric "Pull of a muscle at rest under an imposed pressure, at an imposed contraction"
  extends Interfaces.QuasiStaticRig;
  extends BaseClasses.PressurisedMuscle(muscle(F_start=drive.F_start));
  Interfaces.Signals.LengthInput x(start=0.02) "Imposed contraction"
    annotation (Placement(transformation(extent={{-200,-100},{-180,-80}}),
      iconTransformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.ForceOutput F "Pull of the muscle"
    annotation (Placement(transformation(extent={{150,-40},{170,-20}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Mechanics.ImposedLength drive(x_start=muscle.x_start) "What holds the load end"
    annotation (Placement(transformation(extent={{30,-160},{70,-120}})));
  Instruments.Force force "Load cell"
    annotation (Placement(transformation(extent={{30,-90},{70,-50}})));
equation
  connect(muscle.flange_a, force.flange_a)
    annotation (Line(points={{50,-20}, {50,-50}}, color={0,110,60}));
  connect(force.flange_b, drive.flange)
    annotation (Line(points={{50,-90}, {50,-120}}, color={0,110,60}));
  connect(x, drive.s)
    annotation (Line(points={{-190,-90}, {25,-90}, {25,-140}, {30,-140}}, color={0,0,127}));
  connect(force.F, F)
    annotation (Line(points={{70,-70}, {155,-70}, {155,-30}, {160,-30}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{160,120}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Maps of force over pressure and contraction, data sheets, isometric and isobaric curves: each row is a point at rest,
data sets say <code>kind = &quot;static&quot;</code>. Equilibria of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17), (68)-(71) with der = 0; the fibre friction DP
(69) vanishes with the speed. <code>branch</code> gives dry friction its sign.</p>
</html>"));
end QuasiStaticIsometric;

within PneumaticMuscle.Examples;
model IsometricCycle "A held muscle is moved and its pull measured"
  extends Icons.Example;
  output Types.GaugePressure p = bench.p "Gauge pressure";
  output Types.Force F = bench.F "Pull";
  Sources.Step move(before=0.01, after=0.04, start=5, rise=0.3) "Imposed contraction"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.Isometric bench(u_in=0.3, u_out=0, p_supply=207e3) "Muscle that is held"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(move.y, bench.s)
    annotation (Line(points={{-30,0}, {25,0}, {25,-18}, {30,-18}}, color={0,0,127}));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The pull falls with contraction, and the motion pushes gas back through the open valve.</p>
</html>"));
end IsometricCycle;

within PneumaticMuscle.Examples;
model AntagonisticSwing "Two muscles swing a pulley"
  extends Icons.Example;
  output Types.Length x = bench.x "Travel of the rim";
  Sources.Pulse first(start=-1, stop=4) "Current of the first inlet and the second exhaust valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse second(start=4, stop=100) "Current of the second inlet and the first exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Benches.Antagonistic bench(p_supply=207e3)
    "Pair of muscles"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(first.y, bench.u_in_1)
    annotation (Line(points={{-30,40}, {25,40}, {25,16}, {30,16}}, color={0,0,127}));
  connect(second.y, bench.u_out_1)
    annotation (Line(points={{-30,-40}, {25,-40}, {25,8}, {30,8}}, color={0,0,127}));
  connect(second.y, bench.u_in_2)
    annotation (Line(points={{-30,-40}, {25,-40}, {25,0}, {30,0}}, color={0,0,127}));
  connect(first.y, bench.u_out_2)
    annotation (Line(points={{-30,40}, {21,40}, {21,-8}, {30,-8}}, color={0,0,127}));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>One muscle is filled while the other is vented, then the other way round.</p>
</html>"));
end AntagonisticSwing;

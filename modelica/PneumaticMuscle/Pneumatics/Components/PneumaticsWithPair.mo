within PneumaticMuscle.Pneumatics.Components;
partial model PneumaticsWithPair "What feeds the gas port of a muscle through an inlet and an exhaust valve and a line"
  extends Interfaces.PneumaticsWithLine(shows="p, T");
  extends Icons.Valve;
  Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-90,-65},{-60,-35}})));
  ValvePair pair "Inlet and exhaust valve"
    annotation (Placement(transformation(extent={{-40,-20},{0,20}})));
equation
  connect(pair.exhaust, atmosphere.port)
    annotation (Line(points={{-40,-12}, {-55,-12}, {-55,-50}, {-60,-50}}, color={0,90,160}));
  connect(pair.port, line.port_a)
    annotation (Line(points={{0,0}, {30,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Pneumatics.Components.ValvePair\">Components.ValvePair</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42), (62). Left to the extending class: what
drives the valves, and what stands at <code>pair.supply</code>.</p>
</html>"));
end PneumaticsWithPair;

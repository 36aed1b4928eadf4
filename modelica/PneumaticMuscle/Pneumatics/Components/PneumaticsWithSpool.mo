within PneumaticMuscle.Pneumatics.Components;
partial model PneumaticsWithSpool
  "What feeds the gas port of a muscle through a valve between a supply, the muscle and the exhaust, and a line"
  extends Interfaces.PneumaticsWithLine(shows="p");
  extends Icons.Valve;
  parameter Types.Area A_open(min=1e-9, max=1e-4, nominal=1e-6) = 2e-6 "Effective area of the open valve, either way"
    annotation (Dialog(group="Flow"));
  replaceable model Feed = Laws.Lines.DirectFeed constrainedby Interfaces.Feed "What lies before the valve"
    annotation (choicesAllMatching=true);
  Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-90,45},{-60,75}})));
  Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-90,-75},{-60,-45}})));
  Feed feed "What lies before the valve"
    annotation (Placement(transformation(extent={{-50,45},{-20,75}})));
  Orifice inlet "From the supply"
    annotation (Placement(transformation(extent={{-10,45},{20,75}})));
  Orifice outlet "To the exhaust"
    annotation (Placement(transformation(extent={{5,-75},{-25,-45}})));
equation
  connect(supply.port, feed.port_a)
    annotation (Line(points={{-60,60}, {-50,60}}, color={0,90,160}));
  connect(feed.port_b, inlet.port_a)
    annotation (Line(points={{-20,60}, {-10,60}}, color={0,90,160}));
  connect(inlet.port_b, line.port_a)
    annotation (Line(points={{20,60}, {25,60}, {25,0}, {30,0}}, color={0,90,160}));
  connect(line.port_a, outlet.port_a)
    annotation (Line(points={{30,0}, {10,0}, {10,-60}, {5,-60}}, color={0,90,160}));
  connect(outlet.port_b, atmosphere.port)
    annotation (Line(points={{-25,-60}, {-60,-60}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>One spool opens the muscle to the supply or to the exhaust, through two orifices with the flow of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42). Left to the extending class: the areas
<code>inlet.A</code> and <code>outlet.A</code> by its command, and what stands at <code>supply.p_gauge</code>.</p>
</html>"));
end PneumaticsWithSpool;

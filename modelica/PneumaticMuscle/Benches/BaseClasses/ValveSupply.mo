within PneumaticMuscle.Benches.BaseClasses;
partial model ValveSupply "A supply of known pressure, an inlet and an exhaust valve, and the line behind them"
  extends Icons.Named;
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-200,-130},{-180,-110}}),
      iconTransformation(extent={{-110,-70},{-90,-50}})));
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line
    "Line between the valves and the muscle or vessel"
    annotation (choicesAllMatching=true);
  Pneumatics.Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-170,20},{-130,60}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-170,-60},{-130,-20}})));
  Pneumatics.Components.ValvePair valve "Inlet and exhaust valve"
    annotation (Placement(transformation(extent={{-110,-20},{-70,20}})));
  Line line "Line between the valves and the muscle or vessel"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
equation
  connect(supply.port, valve.supply)
    annotation (Line(points={{-130,40}, {-120,40}, {-120,12}, {-110,12}}, color={0,90,160}));
  connect(valve.port, line.port_a)
    annotation (Line(points={{-70,0}, {-50,0}}, color={0,90,160}));
  connect(valve.exhaust, atmosphere.port)
    annotation (Line(points={{-110,-12}, {-120,-12}, {-120,-40}, {-130,-40}}, color={0,90,160}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-190,-120}, {-179,-120}, {-179,40}, {-170,40}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Pneumatics.Components.ValvePair\">Components.ValvePair</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42), (62). Left to the extending class: what
drives the valves, and what stands at <code>line.port_b</code>.</p>
</html>"));
end ValveSupply;

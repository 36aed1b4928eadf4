within PneumaticMuscle.Benches.BaseClasses;
partial model CurrentSupply "A supply of known pressure behind valves that are driven by currents"
  extends TwoCurrents;
  extends ValveSupply;
equation
  connect(u_in, valve.u_in)
    annotation (Line(points={{-190,60}, {-175,60}, {-175,65}, {-115,65}, {-115,25}, {-98,25},
      {-98,20}}, color={0,0,127}));
  connect(u_out, valve.u_out)
    annotation (Line(points={{-190,-30}, {-175,-30}, {-175,15}, {-124,15}, {-124,29}, {-82,29},
      {-82,20}}, color={0,0,127}));
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62): the current sets the effective area. Left
to the extending class: what stands at <code>line.port_b</code>.</p>
</html>"));
end CurrentSupply;

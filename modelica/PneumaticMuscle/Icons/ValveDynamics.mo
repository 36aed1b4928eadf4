within PneumaticMuscle.Icons;
partial class ValveDynamics "Late valves"
  extends MassEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-75,-70}, {-75,75}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {78,-70}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {-45,-70}, {-45,45}, {70,45}}, color={160,160,160}, pattern=LinePattern.Dash,
      thickness=0.5),
    Line(points={{-45,-70}, {-37.8,-44}, {-30.6,-23.8}, {-23.4,-8.2}, {-16.2,3.8}, {-9.1,13.1}, {-1.9,20.4},
      {5.3,25.9}, {12.5,30.2}, {19.7,33.6}, {26.9,36.2}, {34.1,38.2}, {41.2,39.7}, {48.4,40.9}, {55.6,41.8},
      {62.8,42.6}, {70,43.1}}, color={0,90,160}, thickness=1)}),
    Documentation(info="<html>
<p>A step and what follows it.</p>
</html>"));
end ValveDynamics;

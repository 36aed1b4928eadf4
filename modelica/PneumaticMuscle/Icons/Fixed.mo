within PneumaticMuscle.Icons;
partial class Fixed "What does not move"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-80,0}, {80,0}}, color={60,60,60}, thickness=0.5),
    Line(points={{-57.1,0}, {-80,30}}, color={60,60,60}),
    Line(points={{-34.3,0}, {-57.1,30}}, color={60,60,60}),
    Line(points={{-11.4,0}, {-34.3,30}}, color={60,60,60}),
    Line(points={{11.4,0}, {-11.4,30}}, color={60,60,60}),
    Line(points={{34.3,0}, {11.4,30}}, color={60,60,60}),
    Line(points={{57.1,0}, {34.3,30}}, color={60,60,60}),
    Line(points={{80,0}, {57.1,30}}, color={60,60,60}),
    Line(points={{0,0}, {0,-100}}, color={0,110,60}, thickness=1)}),
    Documentation(info="<html>
<p>A hatched ceiling.</p>
</html>"));
end Fixed;

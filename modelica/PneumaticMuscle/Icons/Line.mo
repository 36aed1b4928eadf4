within PneumaticMuscle.Icons;
partial class Line "A line between the valves and the muscle or vessel"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-30}, {100,30}}, lineColor={0,90,160}, fillColor={225,238,250},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-70,0}, {70,0}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A tube.</p>
</html>"));
end Line;

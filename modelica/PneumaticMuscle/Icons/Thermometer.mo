within PneumaticMuscle.Icons;
partial class Thermometer "A thermometer"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{0,-100}, {0,-80}}, color={0,90,160}, thickness=1),
    Rectangle(extent={{-12,-40}, {12,90}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=12),
    Ellipse(extent={{-25,-80}, {25,-30}}, lineColor={110,60,140}, fillColor={190,30,0},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-5,-40}, {5,40}}, lineColor={190,30,0}, fillColor={190,30,0}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Line(points={{12,70}, {30,70}}, color={110,60,140}, thickness=0.5),
    Line(points={{12,45}, {30,45}}, color={110,60,140}, thickness=0.5),
    Line(points={{12,20}, {30,20}}, color={110,60,140}, thickness=0.5)}),
    Documentation(info="<html>
<p>A bulb.</p>
</html>"));
end Thermometer;

within PneumaticMuscle.Icons;
partial class Channel "A measuring channel"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-60,-40}, {60,40}}, lineColor={110,60,140}, fillColor={245,245,245},
    fillPattern=FillPattern.Solid,
      lineThickness=1),
    Line(points={{-100,0}, {-60,0}}, color={110,60,140}, thickness=0.5),
    Line(points={{60,0}, {95,0}}, color={110,60,140}, thickness=0.5, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{-45,-15}, {-25,15}, {-5,-15}, {15,15}, {35,-15}, {45,0}}, color={110,60,140}, thickness=0.5)}),
    Documentation(info="<html>
<p>A box that a signal passes.</p>
</html>"));
end Channel;

within PneumaticMuscle.Icons;
partial class TemperatureSensor "A thermometer out of true"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-48,-30}, {-28,85}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Ellipse(extent={{-60,-70}, {-16,-26}}, lineColor={110,60,140}, fillColor={190,30,0},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-42,-35}, {-34,30}}, lineColor={190,30,0}, fillColor={190,30,0},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-25,30}, {70,30}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5),
    Line(points={{70,60}, {-20,60}}, color={110,60,140}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A bulb whose mark is off.</p>
</html>"));
end TemperatureSensor;

within PneumaticMuscle.Icons;
partial class Example "An example"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={160,160,160}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Ellipse(extent={{-90,-90}, {90,90}}, lineColor={75,138,73}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Polygon(points={{-36,60}, {64,0}, {-36,-60}, {-36,60}}, lineColor={75,138,73}, fillColor={75,138,73},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A triangle, as on a button that plays.</p>
</html>"));
end Example;

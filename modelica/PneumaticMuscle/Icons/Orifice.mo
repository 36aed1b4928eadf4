within PneumaticMuscle.Icons;
partial class Orifice "An opening"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-60}, {100,60}}, lineColor={0,90,160}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Polygon(points={{-25,60}, {25,60}, {0,14}, {-25,60}}, lineColor={60,60,60}, fillColor={60,60,60},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Polygon(points={{-25,-60}, {25,-60}, {0,-14}, {-25,-60}}, lineColor={60,60,60}, fillColor={60,60,60},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-80,0}, {80,0}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>Two wedges.</p>
</html>"));
end Orifice;

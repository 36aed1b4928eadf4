within PneumaticMuscle.Icons;
partial class Muscle "A muscle"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-100,0}, {-52,0}}, color={0,90,160}, thickness=1),
    Polygon(points={{-25,80}, {-45,50}, {-55,0}, {-45,-50}, {-25,-80}, {25,-80}, {45,-50}, {55,0}, {45,50}, {25,80},
      {-25,80}}, lineColor={60,60,60}, fillColor={245,235,215}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Line(points={{-40,58}, {45,-50}}, color={60,60,60}),
    Line(points={{-53,22}, {28,-76}}, color={60,60,60}),
    Line(points={{-50,-25}, {5,-80}}, color={60,60,60}),
    Line(points={{-8,80}, {53,-15}}, color={60,60,60}),
    Line(points={{22,80}, {50,30}}, color={60,60,60}),
    Line(points={{40,58}, {-45,-50}}, color={60,60,60}),
    Line(points={{53,22}, {-28,-76}}, color={60,60,60}),
    Line(points={{50,-25}, {-5,-80}}, color={60,60,60}),
    Line(points={{8,80}, {-53,-15}}, color={60,60,60}),
    Line(points={{-22,80}, {-50,30}}, color={60,60,60}),
    Rectangle(extent={{-30,80}, {30,100}}, lineColor={60,60,60}, fillColor={160,160,160},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-30,-100}, {30,-80}}, lineColor={60,60,60}, fillColor={160,160,160},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A braid between two end fittings.</p>
</html>"));
end Muscle;

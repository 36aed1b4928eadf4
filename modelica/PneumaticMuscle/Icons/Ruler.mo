within PneumaticMuscle.Icons;
partial class Ruler "An instrument of length"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-70,-35}, {70,35}}, lineColor={110,60,140}, fillColor={245,245,245},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Line(points={{-60,35}, {-60,18}}, color={110,60,140}, thickness=0.5),
    Line(points={{-40,35}, {-40,5}}, color={110,60,140}, thickness=0.5),
    Line(points={{-20,35}, {-20,18}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,35}, {0,5}}, color={110,60,140}, thickness=0.5),
    Line(points={{20,35}, {20,18}}, color={110,60,140}, thickness=0.5),
    Line(points={{40,35}, {40,5}}, color={110,60,140}, thickness=0.5),
    Line(points={{60,35}, {60,18}}, color={110,60,140}, thickness=0.5),
    Line(points={{-100,0}, {-70,0}}, color={0,110,60}, thickness=1)}),
    Documentation(info="<html>
<p>A ruler.</p>
</html>"));
end Ruler;

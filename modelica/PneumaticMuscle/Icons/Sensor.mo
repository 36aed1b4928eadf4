within PneumaticMuscle.Icons;
partial class Sensor "An instrument"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-70,-70}, {70,70}}, lineColor={110,60,140}, fillColor={245,245,245},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Line(points={{-50,0}, {-35,0}}, color={110,60,140}, thickness=0.5),
    Line(points={{50,0}, {35,0}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,50}, {0,35}}, color={110,60,140}, thickness=0.5),
    Line(points={{-35,35}, {-25,25}}, color={110,60,140}, thickness=0.5),
    Line(points={{35,35}, {25,25}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,0}, {32,38}}, color={110,60,140}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Ellipse(extent={{-6,-6}, {6,6}}, lineColor={110,60,140}, fillColor={110,60,140}, fillPattern=FillPattern.Solid,
      lineThickness=0.5)}),
    Documentation(info="<html>
<p>A dial.</p>
</html>"));
end Sensor;

within PneumaticMuscle.Icons;
partial class Validation "A model against a paper"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={75,138,73}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=10),
    Line(points={{-75,-70}, {-75,75}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {78,-70}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {-65.9,-49.7}, {-56.9,-33.6}, {-47.8,-20.7}, {-38.8,-10.4}, {-29.7,-2.2}, {-20.6,4.3},
      {-11.6,9.5}, {-2.5,13.7}, {6.6,17}, {15.6,19.6}, {24.7,21.7}, {33.8,23.4}, {42.8,24.7}, {51.9,25.8},
      {60.9,26.7}, {70,27.3}}, color={0,90,160}, thickness=1),
    Ellipse(extent={{-56,-36}, {-44,-24}}, lineColor={60,60,60}, fillColor={60,60,60},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Ellipse(extent={{-31,0}, {-19,12}}, lineColor={60,60,60}, fillColor={60,60,60}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-1,4}, {11,16}}, lineColor={60,60,60}, fillColor={60,60,60}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{32,24}, {44,36}}, lineColor={60,60,60}, fillColor={60,60,60}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Line(points={{20,-35}, {35,-52}, {66,-8}}, color={75,138,73}, thickness=2)}),
    Documentation(info="<html>
<p>A curve through what was measured, and a tick.</p>
</html>"));
end Validation;

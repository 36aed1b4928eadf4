within PneumaticMuscle.Icons;
partial class PressureOffset "A transducer out of true"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-70,-70}, {70,70}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Line(points={{0,-10}, {0,50}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5),
    Line(points={{0,-10}, {38,38}}, color={110,60,140}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Ellipse(extent={{-6,-16}, {6,-4}}, lineColor={110,60,140}, fillColor={110,60,140},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Text(extent={{-35,-65}, {35,-18}}, textString="p", textColor={110,60,140})}),
    Documentation(info="<html>
<p>A dial whose needle is off.</p>
</html>"));
end PressureOffset;

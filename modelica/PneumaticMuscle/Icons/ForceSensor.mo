within PneumaticMuscle.Icons;
partial class ForceSensor "A load cell out of true"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-75,-25}, {-25,25}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Line(points={{-50,25}, {-50,75}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{-50,-25}, {-50,-75}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{-5,-60}, {75,20}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5),
    Line(points={{-5,-35}, {70,60}}, color={110,60,140}, thickness=1)}),
    Documentation(info="<html>
<p>A ring between two pulls, and its characteristic beside the true one.</p>
</html>"));
end ForceSensor;

within PneumaticMuscle.Icons;
partial class EndShape "Ends that are not cylinders"
  extends ForceEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-50,-80}, {50,80}}, lineColor={160,160,160}, pattern=LinePattern.Dash, lineThickness=0.5),
    Line(points={{-18,80}, {-45,55}, {-55,0}, {-45,-55}, {-18,-80}}, color={0,110,60}, thickness=1,
      smooth=Smooth.Bezier),
    Line(points={{18,80}, {45,55}, {55,0}, {45,-55}, {18,-80}}, color={0,110,60}, thickness=1, smooth=Smooth.Bezier),
    Line(points={{-18,80}, {18,80}}, color={0,110,60}, thickness=1),
    Line(points={{-18,-80}, {18,-80}}, color={0,110,60}, thickness=1)}),
    Documentation(info="<html>
<p>A barrel in its cylinder.</p>
</html>"));
end EndShape;

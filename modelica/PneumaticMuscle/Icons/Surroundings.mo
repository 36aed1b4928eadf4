within PneumaticMuscle.Icons;
partial class Surroundings "The air outside"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,90,160}, fillColor={240,248,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=60),
    Line(points={{-65,35}, {-20,35}, {35,60}, {60,35}, {25,20}}, color={0,90,160}, thickness=0.5,
      smooth=Smooth.Bezier),
    Line(points={{-65,0}, {0,0}, {70,25}, {75,-10}, {45,-8}}, color={0,90,160}, thickness=0.5, smooth=Smooth.Bezier),
    Line(points={{-65,-35}, {-10,-35}, {30,-60}, {10,-75}}, color={0,90,160}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Wind.</p>
</html>"));
end Surroundings;

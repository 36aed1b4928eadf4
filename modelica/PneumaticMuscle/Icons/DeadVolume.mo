within PneumaticMuscle.Icons;
partial class DeadVolume "Dead volume"
  extends MassEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-90,-50}, {-25,-50}}, color={0,90,160}, thickness=1),
    Line(points={{25,-50}, {90,-50}}, color={0,90,160}, thickness=1),
    Line(points={{-90,-75}, {90,-75}}, color={0,90,160}, thickness=1),
    Line(points={{-12,-50}, {-12,-20}}, color={0,90,160}, thickness=1),
    Line(points={{12,-50}, {12,-20}}, color={0,90,160}, thickness=1),
    Line(points={{-25,-50}, {-12,-50}}, color={0,90,160}, thickness=1),
    Line(points={{25,-50}, {12,-50}}, color={0,90,160}, thickness=1),
    Ellipse(extent={{-55,-22}, {55,78}}, lineColor={0,90,160}, fillColor={200,222,242},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Text(extent={{-35,0}, {35,60}}, textString="V", textColor={0,90,160})}),
    Documentation(info="<html>
<p>A pocket beside a line.</p>
</html>"));
end DeadVolume;

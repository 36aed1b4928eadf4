within PneumaticMuscle.Icons;
partial class GasSource "Gas at a given pressure"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-60,-90}, {60,50}}, lineColor={0,90,160}, fillColor={205,225,245},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=40),
    Rectangle(extent={{-20,50}, {20,75}}, lineColor={0,90,160}, fillColor={205,225,245},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{0,-45}, {0,25}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{60,0}, {100,0}}, color={0,90,160}, thickness=1)}),
    Documentation(info="<html>
<p>A bottle.</p>
</html>"));
end GasSource;

within PneumaticMuscle.Icons;
partial class Leak "A leak"
  extends MassEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-25,20}, {0,90}}, lineColor={60,60,60}, fillColor={190,190,190},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-25,-90}, {0,-20}}, lineColor={60,60,60}, fillColor={190,190,190},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-85,0}, {0,0}}, color={0,90,160}, thickness=1),
    Line(points={{0,0}, {80,55}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{0,0}, {85,0}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{0,0}, {80,-55}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>Gas that leaves through a wall.</p>
</html>"));
end Leak;

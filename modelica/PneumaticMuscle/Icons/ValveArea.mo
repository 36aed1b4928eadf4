within PneumaticMuscle.Icons;
partial class ValveArea "Another opening"
  extends MassEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Polygon(points={{-25,85}, {25,85}, {0,20}, {-25,85}}, lineColor={60,60,60}, fillColor={60,60,60},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Polygon(points={{-25,-85}, {25,-85}, {0,-20}, {-25,-85}}, lineColor={60,60,60}, fillColor={60,60,60},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-80,0}, {80,0}}, color={0,90,160}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{-55,-60}, {60,65}}, color={190,30,0}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12)}),
    Documentation(info="<html>
<p>Two wedges and an arrow across.</p>
</html>"));
end ValveArea;

within PneumaticMuscle.Icons;
partial class Signal "A signal that depends on time alone"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,0,127}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Line(points={{-75,-70}, {-75,75}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {78,-70}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-40}, {-40,-40}, {-28,35}, {5,35}}, color={0,0,127}, thickness=0.5),
    Line(points={{5,35}, {20,60}, {38,-30}, {70,20}}, color={0,0,127}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>A step and a wave.</p>
</html>"));
end Signal;

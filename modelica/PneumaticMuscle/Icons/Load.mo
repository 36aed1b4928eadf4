within PneumaticMuscle.Icons;
partial class Load "A mass that hangs"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{0,100}, {0,50}}, color={60,60,60}, thickness=1),
    Ellipse(extent={{-12,30}, {12,54}}, lineColor={60,60,60}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Polygon(points={{-50,30}, {50,30}, {80,-90}, {-80,-90}, {-50,30}}, lineColor={60,60,60},
      fillColor={190,190,190}, fillPattern=FillPattern.Solid, lineThickness=0.5),
    Text(extent={{-50,-80}, {50,20}}, textString="m", textColor={60,60,60})}),
    Documentation(info="<html>
<p>A weight on a hook.</p>
</html>"));
end Load;

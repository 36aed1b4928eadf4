within PneumaticMuscle.Icons;
partial class Bench "A bench"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={160,160,160}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Line(points={{-60,-85}, {-60,80}, {60,80}}, color={60,60,60}, thickness=1),
    Line(points={{-90,-85}, {90,-85}}, color={60,60,60}, thickness=1),
    Line(points={{20,80}, {20,60}}, color={60,60,60}, thickness=0.5),
    Polygon(points={{10,60}, {2,30}, {10,-5}, {30,-5}, {38,30}, {30,60}, {10,60}}, lineColor={60,60,60},
      fillColor={245,235,215}, fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{4,45}, {36,10}}, color={60,60,60}),
    Line(points={{36,45}, {4,10}}, color={60,60,60}),
    Line(points={{20,-5}, {20,-20}}, color={60,60,60}, thickness=0.5),
    Polygon(points={{8,-20}, {32,-20}, {42,-55}, {-2,-55}, {8,-20}}, lineColor={60,60,60}, fillColor={190,190,190},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A muscle in a frame.</p>
</html>"));
end Bench;

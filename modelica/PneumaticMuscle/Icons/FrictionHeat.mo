within PneumaticMuscle.Icons;
partial class FrictionHeat "Heat of friction"
  extends EnergyEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-45,-30}, {45,10}}, lineColor={190,30,0}, fillColor={250,190,170},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-80,-30}, {80,-30}}, color={60,60,60}, thickness=0.5),
    Line(points={{-57.1,-30}, {-80,-46}}, color={60,60,60}),
    Line(points={{-34.3,-30}, {-57.1,-46}}, color={60,60,60}),
    Line(points={{-11.4,-30}, {-34.3,-46}}, color={60,60,60}),
    Line(points={{11.4,-30}, {-11.4,-46}}, color={60,60,60}),
    Line(points={{34.3,-30}, {11.4,-46}}, color={60,60,60}),
    Line(points={{57.1,-30}, {34.3,-46}}, color={60,60,60}),
    Line(points={{80,-30}, {57.1,-46}}, color={60,60,60}),
    Line(points={{-28,22}, {-16,34}, {-40,58}, {-28,70}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier),
    Line(points={{0,22}, {12,34}, {-12,58}, {0,70}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier),
    Line(points={{28,22}, {40,34}, {16,58}, {28,70}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>A block on the ground and heat.</p>
</html>"));
end FrictionHeat;

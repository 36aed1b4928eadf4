within PneumaticMuscle.Icons;
partial class Wall "A law of the wall"
  extends EnergyLaw;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-25,-80}, {25,80}}, lineColor={60,60,60}, fillColor={225,225,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-25,-80}, {25,-50}}, color={60,60,60}),
    Line(points={{-25,-58}, {25,-28}}, color={60,60,60}),
    Line(points={{-25,-36}, {25,-6}}, color={60,60,60}),
    Line(points={{-25,-14}, {25,16}}, color={60,60,60}),
    Line(points={{-25,8}, {25,38}}, color={60,60,60}),
    Line(points={{-25,30}, {25,60}}, color={60,60,60}),
    Line(points={{-25,52}, {25,82}}, color={60,60,60}),
    Line(points={{-80,0}, {-32,0}}, color={190,30,0}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{32,0}, {80,0}}, color={190,30,0}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A hatched wall between two sides.</p>
</html>"));
end Wall;

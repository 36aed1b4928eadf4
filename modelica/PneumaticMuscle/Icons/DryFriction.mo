within PneumaticMuscle.Icons;
partial class DryFriction "Dry friction"
  extends ForceEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-45,-25}, {45,35}}, lineColor={60,60,60}, fillColor={225,225,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-80,-25}, {80,-25}}, color={60,60,60}, thickness=0.5),
    Line(points={{-57.1,-25}, {-80,-41}}, color={60,60,60}),
    Line(points={{-34.3,-25}, {-57.1,-41}}, color={60,60,60}),
    Line(points={{-11.4,-25}, {-34.3,-41}}, color={60,60,60}),
    Line(points={{11.4,-25}, {-11.4,-41}}, color={60,60,60}),
    Line(points={{34.3,-25}, {11.4,-41}}, color={60,60,60}),
    Line(points={{57.1,-25}, {34.3,-41}}, color={60,60,60}),
    Line(points={{80,-25}, {57.1,-41}}, color={60,60,60}),
    Line(points={{45,5}, {85,5}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A block on the ground.</p>
</html>"));
end DryFriction;

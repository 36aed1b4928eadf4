within PneumaticMuscle.Icons;
partial class MovingMass "Mass that moves along"
  extends ForceEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-60,-40}, {30,45}}, lineColor={60,60,60}, fillColor={190,190,190},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Text(extent={{-50,-30}, {20,35}}, textString="m", textColor={60,60,60}),
    Line(points={{30,0}, {85,0}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{-15,-40}, {-15,-85}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12)}),
    Documentation(info="<html>
<p>A mass and its acceleration.</p>
</html>"));
end MovingMass;

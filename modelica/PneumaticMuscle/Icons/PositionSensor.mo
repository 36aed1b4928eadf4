within PneumaticMuscle.Icons;
partial class PositionSensor "A displacement transducer out of true"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-75,-60}, {75,-10}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Line(points={{-60,-10}, {-60,-35}}, color={110,60,140}, thickness=0.5),
    Line(points={{-30,-10}, {-30,-25}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,-10}, {0,-35}}, color={110,60,140}, thickness=0.5),
    Line(points={{30,-10}, {30,-25}}, color={110,60,140}, thickness=0.5),
    Line(points={{60,-10}, {60,-35}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,-5}, {0,70}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5),
    Line(points={{35,70}, {35,-5}}, color={110,60,140}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A ruler whose mark is off.</p>
</html>"));
end PositionSensor;

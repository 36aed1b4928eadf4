within PneumaticMuscle.Icons;
partial class Braid "A law of the sleeve"
  extends ForceLaw;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-40,-80}, {40,80}}, lineColor={60,60,60}, fillColor={245,235,215},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-40,60}, {40,-20}}, color={60,60,60}),
    Line(points={{-40,20}, {40,-60}}, color={60,60,60}),
    Line(points={{-40,-20}, {20,-80}}, color={60,60,60}),
    Line(points={{-20,80}, {40,20}}, color={60,60,60}),
    Line(points={{40,60}, {-40,-20}}, color={60,60,60}),
    Line(points={{40,20}, {-40,-60}}, color={60,60,60}),
    Line(points={{40,-20}, {-20,-80}}, color={60,60,60}),
    Line(points={{20,80}, {-40,20}}, color={60,60,60})}),
    Documentation(info="<html>
<p>A cylinder with fibres.</p>
</html>"));
end Braid;

within PneumaticMuscle.Icons;
partial class Pulley "A wheel"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-60,-80}, {60,40}}, lineColor={60,60,60}, fillColor={225,225,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Ellipse(extent={{-10,-30}, {10,-10}}, lineColor={60,60,60}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-60,100}, {-60,-20}}, color={0,110,60}, thickness=1),
    Line(points={{60,100}, {60,-20}}, color={0,110,60}, thickness=1)}),
    Documentation(info="<html>
<p>A wheel with a belt.</p>
</html>"));
end Pulley;

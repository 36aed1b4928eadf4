within PneumaticMuscle.Icons;
partial class Motion "A motion that is imposed"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-60,-60}, {60,60}}, lineColor={0,110,60}, fillColor={230,245,235},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Line(points={{0,0}, {0,50}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{0,0}, {0,-50}}, color={0,110,60}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{0,60}, {0,100}}, color={0,110,60}, thickness=1)}),
    Documentation(info="<html>
<p>An arrow both ways.</p>
</html>"));
end Motion;

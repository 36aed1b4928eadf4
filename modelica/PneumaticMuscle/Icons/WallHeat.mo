within PneumaticMuscle.Icons;
partial class WallHeat "A warm wall"
  extends EnergyEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-30,-80}, {-10,80}}, lineColor={190,30,0}, fillColor={250,120,90},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-10,-80}, {10,80}}, lineColor={190,30,0}, fillColor={252,175,150},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{10,-80}, {30,80}}, lineColor={190,30,0}, fillColor={254,220,205},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-85,0}, {-36,0}}, color={190,30,0}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Line(points={{36,0}, {85,0}}, color={190,30,0}, thickness=0.5, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A wall that is warm on one side.</p>
</html>"));
end WallHeat;

within PneumaticMuscle.Icons;
partial class GasEnergy "Gas with an energy balance"
  extends EnergyEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-80,-45}, {30,65}}, lineColor={0,90,160}, fillColor={225,238,250},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Ellipse(extent={{-52,23}, {-38,37}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-15,25}, {-1,39}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-32,-7}, {-18,7}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-57,-19}, {-43,-5}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-5,-15}, {9,-1}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Line(points={{30,10}, {85,10}}, color={190,30,0}, thickness=1, arrow={Arrow.None, Arrow.Filled}, arrowSize=12),
    Text(extent={{-60,-92}, {10,-48}}, textString="U", textColor={190,30,0}),
    Line(points={{55,22}, {67,31}, {43,49}, {55,58}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier),
    Line(points={{55,-42}, {67,-33}, {43,-15}, {55,-6}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Molecules and heat.</p>
</html>"));
end GasEnergy;

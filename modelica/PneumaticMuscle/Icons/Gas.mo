within PneumaticMuscle.Icons;
partial class Gas "A law of the gas"
  extends EnergyLaw;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-70,-70}, {70,70}}, lineColor={0,90,160}, fillColor={225,238,250},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Ellipse(extent={{-38,17}, {-22,33}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{12,27}, {28,43}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{27,-23}, {43,-7}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-23,-43}, {-7,-27}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Ellipse(extent={{-10,-5}, {6,11}}, lineColor={0,90,160}, fillColor={0,90,160}, fillPattern=FillPattern.Solid,
      lineThickness=0.5),
    Line(points={{20,35}, {45,48}}, color={0,90,160}, thickness=0.5),
    Line(points={{-15,-35}, {-40,-48}}, color={0,90,160}, thickness=0.5),
    Line(points={{-30,25}, {-48,8}}, color={0,90,160}, thickness=0.5)}),
    Documentation(info="<html>
<p>Molecules.</p>
</html>"));
end Gas;

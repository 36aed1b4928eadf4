within PneumaticMuscle.Icons;
partial class HeatOfFriction "What becomes of the heat of friction"
  extends EnergyLaw;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-45,-10}, {45,30}}, lineColor={60,60,60}, fillColor={225,225,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-75,-10}, {75,-10}}, color={60,60,60}, thickness=0.5),
    Line(points={{-53.6,-10}, {-75,-26}}, color={60,60,60}),
    Line(points={{-32.1,-10}, {-53.6,-26}}, color={60,60,60}),
    Line(points={{-10.7,-10}, {-32.1,-26}}, color={60,60,60}),
    Line(points={{10.7,-10}, {-10.7,-26}}, color={60,60,60}),
    Line(points={{32.1,-10}, {10.7,-26}}, color={60,60,60}),
    Line(points={{53.6,-10}, {32.1,-26}}, color={60,60,60}),
    Line(points={{75,-10}, {53.6,-26}}, color={60,60,60}),
    Line(points={{-25,36}, {-13,45}, {-37,63}, {-25,72}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier),
    Line(points={{0,36}, {12,45}, {-12,63}, {0,72}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier),
    Line(points={{25,36}, {37,45}, {13,63}, {25,72}}, color={190,30,0}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Two surfaces and heat.</p>
</html>"));
end HeatOfFriction;

within PneumaticMuscle.Icons;
partial class PressureSensorLag "A pressure transducer that follows late"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-85,20}, {-15,90}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Text(extent={{-70,35}, {-30,75}}, textString="p", textColor={110,60,140}),
    Line(points={{-70,-70}, {-40,-70}, {-40,10}, {80,10}}, color={160,160,160}, pattern=LinePattern.Dash,
    thickness=0.5),
    Line(points={{-70,-70}, {-40,-70}, {-25,-40}, {-5,-18}, {20,-4}, {50,4}, {80,8}}, color={110,60,140},
    thickness=1)}),
    Documentation(info="<html>
<p>A dial, and a reading that comes late.</p>
</html>"));
end PressureSensorLag;

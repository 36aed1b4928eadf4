within PneumaticMuscle.Icons;
partial class Saturation "A reading that ends at a limit"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-80,35}, {80,35}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5),
    Line(points={{-30,35}, {-15,62}, {0,70}, {15,62}, {30,35}}, color={160,160,160}, pattern=LinePattern.Dash,
    thickness=0.5),
    Line(points={{-80,-70}, {-60,-45}, {-30,35}, {30,35}, {60,-45}, {80,-70}}, color={110,60,140}, thickness=1)}),
    Documentation(info="<html>
<p>A wave whose top is cut off.</p>
</html>"));
end Saturation;

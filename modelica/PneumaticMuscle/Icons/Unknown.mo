within PneumaticMuscle.Icons;
partial class Unknown "A term without a law"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={160,160,160}, fillColor={245,245,245},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=25),
    Text(extent={{-80,-85}, {80,85}}, textString="?", textColor={60,60,60})}),
    Documentation(info="<html>
<p>A question mark.</p>
</html>"));
end Unknown;

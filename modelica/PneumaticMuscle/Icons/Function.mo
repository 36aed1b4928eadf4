within PneumaticMuscle.Icons;
partial function Function "A function"
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Text(extent={{-150,110}, {150,150}}, textString="%name", textColor={0,0,255}),
    Ellipse(extent={{-100,-100}, {100,100}}, lineColor={120,100,0}, fillColor={255,250,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Text(extent={{-80,-80}, {80,80}}, textString="f", textColor={120,100,0})}),
    Documentation(info="<html>
<p>An ellipse with an f.</p>
</html>"));
end Function;

within PneumaticMuscle.Icons;
partial class ReadingEffect "An effect on a reading"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={110,60,140}, fillColor={240,235,243},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=25)}),
    Documentation(info="<html>
<p>A tinted frame in the colour of the balance.</p>
</html>"));
end ReadingEffect;

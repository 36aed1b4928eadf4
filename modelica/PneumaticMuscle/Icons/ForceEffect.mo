within PneumaticMuscle.Icons;
partial class ForceEffect "An effect in the balance of force"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,110,60}, fillColor={229,240,235},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=25)}),
    Documentation(info="<html>
<p>A tinted frame in the colour of the balance.</p>
</html>"));
end ForceEffect;

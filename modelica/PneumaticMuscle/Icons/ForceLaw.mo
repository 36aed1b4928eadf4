within PneumaticMuscle.Icons;
partial class ForceLaw "A law in the balance of force"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,110,60}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A white frame in the colour of the balance.</p>
</html>"));
end ForceLaw;

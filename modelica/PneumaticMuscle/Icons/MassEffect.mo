within PneumaticMuscle.Icons;
partial class MassEffect "An effect in the balance of mass"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,90,160}, fillColor={229,238,245},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=25)}),
    Documentation(info="<html>
<p>A tinted frame in the colour of the balance.</p>
</html>"));
end MassEffect;

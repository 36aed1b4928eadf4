within PneumaticMuscle.Icons;
partial class MassLaw "A law in the balance of mass"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,90,160}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A white frame in the colour of the balance.</p>
</html>"));
end MassLaw;

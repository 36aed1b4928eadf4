within PneumaticMuscle.Icons;
partial class EnergyEffect "An effect in the balance of energy"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={190,30,0}, fillColor={248,232,229},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=25)}),
    Documentation(info="<html>
<p>A tinted frame in the colour of the balance.</p>
</html>"));
end EnergyEffect;

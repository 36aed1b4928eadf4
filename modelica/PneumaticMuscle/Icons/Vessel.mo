within PneumaticMuscle.Icons;
partial class Vessel "A vessel"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-60}, {100,60}}, lineColor={0,90,160}, fillColor={225,238,250},
      fillPattern=FillPattern.Solid, lineThickness=1, radius=55),
    Line(points={{-55,-60}, {-55,60}}, color={0,90,160}),
    Line(points={{55,-60}, {55,60}}, color={0,90,160})}),
    Documentation(info="<html>
<p>A tank with round ends.</p>
</html>"));
end Vessel;

within PneumaticMuscle.Icons;
partial record Record "A record"
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Text(extent={{-150,110}, {150,150}}, textString="%name", textColor={0,0,255}),
    Rectangle(extent={{-100,-75}, {100,75}}, lineColor={100,90,0}, fillColor={255,255,220},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Line(points={{-100,25}, {100,25}}, color={100,90,0}, thickness=0.5),
    Line(points={{-100,-25}, {100,-25}}, color={100,90,0}, thickness=0.5),
    Line(points={{-20,75}, {-20,-75}}, color={100,90,0}, thickness=0.5)}),
    Documentation(info="<html>
<p>A table.</p>
</html>"));
end Record;

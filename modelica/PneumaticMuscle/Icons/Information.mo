within PneumaticMuscle.Icons;
partial class Information "Documentation to be read"
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-90,-90}, {90,90}}, lineColor={80,110,180}, fillColor={240,245,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Ellipse(extent={{-12,38}, {12,62}}, lineColor={80,110,180}, fillColor={80,110,180},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-12,-60}, {12,22}}, lineColor={80,110,180}, fillColor={80,110,180},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A page.</p>
</html>"));
end Information;

within PneumaticMuscle.Icons;
partial package Package "A package"
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Polygon(points={{-100,-90}, {-100,80}, {-30,80}, {-10,55}, {100,55}, {100,-90}, {-100,-90}},
      lineColor={120,120,110}, fillColor={240,240,230}, fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-100,40}, {100,40}}, color={120,120,110}, thickness=0.5)}),
    Documentation(info="<html>
<p>A folder.</p>
</html>"));
end Package;

within PneumaticMuscle.Icons;
partial class Valve "Valves"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,90,160}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Polygon(points={{-70,40}, {-70,-40}, {0,0}, {-70,40}}, lineColor={0,90,160}, fillColor={205,225,245},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Polygon(points={{70,40}, {70,-40}, {0,0}, {70,40}}, lineColor={0,90,160}, fillColor={205,225,245},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{0,0}, {0,50}}, color={0,90,160}, thickness=0.5),
    Rectangle(extent={{-25,50}, {25,80}}, lineColor={60,60,60}, fillColor={225,225,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>Two triangles.</p>
</html>"));
end Valve;

within PneumaticMuscle.Icons;
partial class ThermocoupleLag "A late thermometer"
  extends ReadingEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-68,-30}, {-48,85}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=0.5, radius=10),
    Ellipse(extent={{-80,-70}, {-36,-26}}, lineColor={110,60,140}, fillColor={190,30,0},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Rectangle(extent={{-62,-35}, {-54,40}}, lineColor={190,30,0}, fillColor={190,30,0},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-20,-60}, {0,-60}, {0,50}, {80,50}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5),
    Line(points={{0,-60}, {5,-40.1}, {10,-23.7}, {15,-10.4}, {20,0.6}, {25,9.5}, {30,16.9}, {35,22.9}, {40,27.8},
      {45,31.8}, {50,35.1}, {55,37.8}, {60,40}, {65,41.8}, {70,43.3}, {75,44.5}, {80,45.5}}, color={110,60,140},
      thickness=1)}),
    Documentation(info="<html>
<p>A bulb, and a reading that comes late.</p>
</html>"));
end ThermocoupleLag;

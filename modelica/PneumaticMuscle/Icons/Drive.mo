within PneumaticMuscle.Icons;
partial class Drive "Dynamics of the valves"
  extends MassLaw;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-60,-20}, {30,50}}, lineColor={0,90,160}, fillColor={225,225,225},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{-55,-20}, {-40,50}}, color={0,90,160}, thickness=0.5),
    Line(points={{-37,-20}, {-22,50}}, color={0,90,160}, thickness=0.5),
    Line(points={{-19,-20}, {-4,50}}, color={0,90,160}, thickness=0.5),
    Line(points={{-1,-20}, {14,50}}, color={0,90,160}, thickness=0.5),
    Line(points={{17,-20}, {32,50}}, color={0,90,160}, thickness=0.5),
    Rectangle(extent={{-85,5}, {75,25}}, lineColor={60,60,60}, fillColor={190,190,190},
      fillPattern=FillPattern.Solid, lineThickness=0.5),
    Line(points={{75,15}, {92,15}}, color={60,60,60}, thickness=1),
    Text(extent={{-40,-85}, {40,-25}}, textString="u", textColor={0,90,160})}),
    Documentation(info="<html>
<p>A coil and its plunger.</p>
</html>"));
end Drive;

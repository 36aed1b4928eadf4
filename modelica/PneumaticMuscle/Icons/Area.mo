within PneumaticMuscle.Icons;
partial class Area "A law of the effective areas"
  extends MassLaw;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-75,-70}, {-75,75}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {78,-70}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {-35,-70}, {60,55}}, color={0,90,160}, thickness=1)}),
    Documentation(info="<html>
<p>Area by current.</p>
</html>"));
end Area;

within PneumaticMuscle.Icons;
partial class Stop "A stop at full extension"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{0,100}, {0,70}}, color={0,110,60}, thickness=1),
    Line(points={{-60,70}, {60,70}}, color={0,110,60}, thickness=0.5),
    Line(points={{0,-100}, {0,-75}}, color={0,110,60}, thickness=1),
    Line(points={{-60,-75}, {60,-75}}, color={0,110,60}, thickness=0.5),
    Line(points={{-40,70}, {-40,50}, {-60,40}, {-20,20}, {-60,0}, {-20,-20}, {-40,-30}, {-40,-55}},
      color={0,110,60}, thickness=0.5),
    Line(points={{40,70}, {40,10}}, color={0,110,60}, thickness=0.5),
    Line(points={{20,10}, {60,10}}, color={0,110,60}, thickness=0.5),
    Line(points={{15,30}, {15,-20}, {65,-20}, {65,30}}, color={0,110,60}, thickness=0.5),
    Line(points={{40,-20}, {40,-55}}, color={0,110,60}, thickness=0.5),
    Line(points={{-65,-55}, {65,-55}}, color={60,60,60}, thickness=1)}),
    Documentation(info="<html>
<p>A spring and a damper on one side.</p>
</html>"));
end Stop;

within PneumaticMuscle.Icons;
partial class Recorder "A recorder, by its clock"
  extends Named;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-70,-70}, {70,70}}, lineColor={110,60,140}, fillColor={255,255,255},
      fillPattern=FillPattern.Solid, lineThickness=1),
    Line(points={{0,70}, {0,55}}, color={110,60,140}, thickness=0.5),
    Line(points={{70,0}, {55,0}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,-70}, {0,-55}}, color={110,60,140}, thickness=0.5),
    Line(points={{-70,0}, {-55,0}}, color={110,60,140}, thickness=0.5),
    Line(points={{0,0}, {0,45}}, color={110,60,140}, thickness=1),
    Line(points={{0,0}, {30,0}}, color={110,60,140}, thickness=1)}),
    Documentation(info="<html>
<p>A face with two hands.</p>
</html>"));
end Recorder;

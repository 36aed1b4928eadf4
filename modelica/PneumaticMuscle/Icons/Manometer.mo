within PneumaticMuscle.Icons;
partial class Manometer "A pressure transducer"
  extends Sensor;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{0,-100}, {0,-70}}, color={0,90,160}, thickness=1),
    Text(extent={{-35,-68}, {35,-12}}, textString="p", textColor={110,60,140})}),
    Documentation(info="<html>
<p>A dial with a p.</p>
</html>"));
end Manometer;

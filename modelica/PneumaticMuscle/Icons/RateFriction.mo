within PneumaticMuscle.Icons;
partial class RateFriction "Friction by speed"
  extends ForceEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-85,0}, {-5,0}}, color={0,110,60}, thickness=1),
    Line(points={{-5,28}, {-5,-28}}, color={0,110,60}, thickness=1),
    Line(points={{-40,38}, {45,38}, {45,-38}, {-40,-38}}, color={60,60,60}, thickness=1),
    Line(points={{45,0}, {85,0}}, color={0,110,60}, thickness=1)}),
    Documentation(info="<html>
<p>A dashpot.</p>
</html>"));
end RateFriction;

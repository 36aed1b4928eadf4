within PneumaticMuscle.Icons;
partial class Elasticity "Springs"
  extends ForceEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-75,35}, {-75,-35}}, color={60,60,60}, thickness=1),
    Line(points={{-75,0}, {-62.5,0}, {-56.2,26}, {-43.8,-26}, {-31.2,26}, {-18.8,-26}, {-6.2,26}, {6.2,-26},
      {18.8,26}, {31.2,-26}, {43.8,26}, {56.2,-26}, {62.5,0}, {75,0}}, color={0,110,60}, thickness=0.5),
    Line(points={{75,35}, {75,-35}}, color={60,60,60}, thickness=1)}),
    Documentation(info="<html>
<p>A spring between two ends.</p>
</html>"));
end Elasticity;

within PneumaticMuscle.Icons;
partial class Creep "Creep"
  extends ForceEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-75,-70}, {-75,75}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {78,-70}}, color={160,160,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled},
      arrowSize=12),
    Line(points={{-75,-70}, {-70,5}, {-60,20}, {-30,33}, {10,43}, {65,52}}, color={0,110,60}, thickness=1),
    Line(points={{-68,20}, {65,20}}, color={160,160,160}, pattern=LinePattern.Dash, thickness=0.5)}),
    Documentation(info="<html>
<p>A contraction that creeps on.</p>
</html>"));
end Creep;

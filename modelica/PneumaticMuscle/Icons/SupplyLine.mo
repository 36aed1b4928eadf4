within PneumaticMuscle.Icons;
partial class SupplyLine "A line"
  extends MassEffect;
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Line(points={{-90,45}, {40,45}, {65,20}, {65,5}, {40,-15}, {-30,-15}, {-45,-28}, {-30,-45}, {90,-45}},
      color={150,190,225}, thickness=3),
    Line(points={{-90,45}, {40,45}, {65,20}, {65,5}, {40,-15}, {-30,-15}, {-45,-28}, {-30,-45}, {88,-45}},
      color={0,90,160}, thickness=0.5, arrow={Arrow.None, Arrow.Filled}, arrowSize=12)}),
    Documentation(info="<html>
<p>A long tube.</p>
</html>"));
end SupplyLine;

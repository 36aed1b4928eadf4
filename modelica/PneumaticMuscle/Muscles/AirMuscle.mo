within PneumaticMuscle.Muscles;
model AirMuscle "Air muscle of the slides, with Kang's force"
  extends AnyGeometry(redeclare replaceable record Sleeve = Data.AirMuscle constrainedby Data.SleeveData,
    redeclare replaceable model Braid = Laws.Forces.Kang constrainedby Interfaces.Braid);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>AM, theoretical force equations 1 to 3, q = 1 + 3 exp(-2e-6 P); <code>Data.AirMuscle</code>. Gas, heat and friction are
those of DP.</p>
</html>"));
end AirMuscle;

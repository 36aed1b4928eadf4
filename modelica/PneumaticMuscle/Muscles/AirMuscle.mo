within PneumaticMuscle.Muscles;
model AirMuscle "Air muscle of the slides, with Kang's force"
  extends AnyGeometry(redeclare replaceable record Sleeve = Data.AirMuscle constrainedby Data.SleeveData,
    redeclare replaceable model Braid = Laws.Forces.Kang constrainedby Interfaces.Braid);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equations 1 to 3, q = 1 + 3
exp(-2e-6 P); <a href=\"modelica://PneumaticMuscle.Muscles.Data.AirMuscle\">Data.AirMuscle</a>. Gas, heat and friction
are those of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>.</p>
</html>"));
end AirMuscle;

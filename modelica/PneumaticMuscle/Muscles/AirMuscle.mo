within PneumaticMuscle.Muscles;
model AirMuscle "Air muscle of the slides, with Kang's force"
  extends AnyGeometry(redeclare replaceable record Sleeve = Data.AirMuscle constrainedby Data.SleeveData,
    fibres=1, mu_fb=0, mu_d=0, redeclare replaceable model Braid = Laws.Forces.Kang constrainedby Interfaces.Braid);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equations 1 to 3, q = 1 + 3
exp(-2e-6 P); <a href=\"modelica://PneumaticMuscle.Muscles.Data.AirMuscle\">Data.AirMuscle</a>. Gas and heat are those
of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>. AM have no friction and give neither number nor
width of the fibres: none of DP (68)-(71), and one fibre, so that the whole outside but 1 % exchanges heat. The 216
fibres of DP Table 1 do not fit on it: 148 cm2 of 94 cm2. State <code>fibres</code>, <code>w</code>, <code>z</code>,
<code>mu_fb</code> and <code>mu_d</code> where they are known.</p>
</html>"));
end AirMuscle;

within PneumaticMuscle.Muscles;
model Latex "Muscle with a latex balloon, Doumit and Pardoel"
  extends Physical(usual=false);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 1,
<a href=\"modelica://PneumaticMuscle.Muscles.Data.Latex\">Data.Latex</a>.</p>
</html>"));
end Latex;

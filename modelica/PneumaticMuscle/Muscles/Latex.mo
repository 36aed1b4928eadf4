within PneumaticMuscle.Muscles;
model Latex "Muscle with a latex balloon, Doumit and Pardoel"
  extends Physical(usual=false);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>DP Table 1, <code>Data.Latex</code>.</p>
</html>"));
end Latex;

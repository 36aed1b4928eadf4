within PneumaticMuscle.Muscles;
model Empirical530 "The muscle of 530 mm, Dzahir and Yamamoto"
  extends Empirical(L0=data.L0);
protected
  final parameter Data.EmpiricalMuscleData data = Data.EmpiricalMuscle530() "Data of the paper";
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 2,
<a href=\"modelica://PneumaticMuscle.Muscles.Data.EmpiricalMuscle530\">Data.EmpiricalMuscle530</a>.</p>
</html>"));
end Empirical530;

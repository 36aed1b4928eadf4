within PneumaticMuscle.Muscles;
model Empirical300 "The muscle of 300 mm, Dzahir and Yamamoto"
  extends Empirical(L0=data.L0);
protected
  final parameter Data.EmpiricalMuscleData data = Data.EmpiricalMuscle300() "Data of the paper";
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 2,
<a href=\"modelica://PneumaticMuscle.Muscles.Data.EmpiricalMuscle300\">Data.EmpiricalMuscle300</a>.</p>
</html>"));
end Empirical300;

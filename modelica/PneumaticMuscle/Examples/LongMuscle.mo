within PneumaticMuscle.Examples;
model LongMuscle "The vertical load on the longer of the two muscles, DY section 2"
  extends Benches.VerticalLoad(muscle(L0=data.L0));
  extends Icons.Example;
protected
  final parameter Muscles.Data.EmpiricalMuscleData data = Muscles.Data.EmpiricalMuscle530() "Length by the paper";
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>530 mm in the place of 300 mm, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> Fig. 2b. The same
strain is a longer way, and the mass is accelerated more. The diameter is that of the shorter one: DY print neither.</p>
</html>"));
end LongMuscle;

within PneumaticMuscle.Muscles.Data;
record EmpiricalMuscle530 "The longer of the two muscles, DY section 2"
  extends EmpiricalMuscleData(L0=0.53);
  annotation (Documentation(info="<html>
<p>530 mm, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 2 and Fig. 2.</p>
</html>"));
end EmpiricalMuscle530;

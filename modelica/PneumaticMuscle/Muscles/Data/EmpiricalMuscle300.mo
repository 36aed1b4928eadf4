within PneumaticMuscle.Muscles.Data;
record EmpiricalMuscle300 "The shorter of the two muscles, DY section 2"
  extends EmpiricalMuscleData(L0=0.3);
  annotation (Documentation(info="<html>
<p>300 mm, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 2 and Fig. 2.</p>
</html>"));
end EmpiricalMuscle300;

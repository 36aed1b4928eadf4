within PneumaticMuscle.Muscles.Data;
record Latex "The muscle with a latex balloon for a bladder, DP Table 1"
  extends MuscleData(L0=0.24, t_wall=0.254e-3, k_wall=0.14);
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 1.</p>
</html>"));
end Latex;

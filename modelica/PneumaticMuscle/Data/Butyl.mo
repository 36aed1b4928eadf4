within PneumaticMuscle.Data;
record Butyl "The muscle with a butyl rubber tube for a bladder, DP Table 2"
  extends MuscleData(L0=0.23, t_wall=0.8e-3, k_wall=0.09);
  annotation (Documentation(info="<html>
<p>DP Table 2.</p>
</html>"));
end Butyl;

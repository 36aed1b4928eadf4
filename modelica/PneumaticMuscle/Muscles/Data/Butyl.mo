within PneumaticMuscle.Muscles.Data;
record Butyl "The muscle with a butyl rubber tube for a bladder, DP Table 2"
  extends MuscleData(L0=0.23, t_wall=0.8e-3, k_wall=0.09);
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 2. DP section 6 gives both muscles 24 cm
where the table has 0.23 m for this one; the longer muscle would contract by 67.9 instead of 62.9 mm at 207 kPa, as the
latex muscle does
(<a href=\"modelica://PneumaticMuscle.Examples.Validation.ButylPressure\">Validation.ButylPressure</a>).</p>
</html>"));
end Butyl;

within PneumaticMuscle.Laws.Forces;
model Kang "A factor on the strain that falls with pressure, DP (4), DY (3) and (6), AM"
  extends Empirical(final k=1, final c_3=0, final c_4=0, final c_5=1);
  annotation (Documentation(info="<html>
<p>As Tondu with q(P) = 1 + c_1 exp(c_2 P) in the place of k,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Kang and others 2009</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (4);
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>: c_1 = 3, c_2 = -2e-6 1/Pa.</p>
</html>"));
end Kang;

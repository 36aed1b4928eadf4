within PneumaticMuscle.Laws.Forces;
model Gaylord "Virtual work on a cylinder, DP (1)"
  extends Laws.Forces.CylindricalBraid;
  annotation (Documentation(info="<html>
<p>F = P pi D_90^2/4 (3 cos(theta)^2 - 1), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Gaylord 1958</a> and
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Schulte 1961</a>: cos(theta) = L/b, D_90 = b/(n pi). It is
the base model's own law.</p>
</html>"));
end Gaylord;

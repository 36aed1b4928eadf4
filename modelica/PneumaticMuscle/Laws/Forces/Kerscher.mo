within PneumaticMuscle.Laws.Forces;
model Kerscher "Factors on strain and on force, DY (5)-(7)"
  extends Empirical(final k=1);
  annotation (Documentation(info="<html>
<p>F_s of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (5) with q(P), DY (6), and mu(eps), DY
(7), after <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Kerscher and others 2006</a>.</p>
</html>"));
end Kerscher;

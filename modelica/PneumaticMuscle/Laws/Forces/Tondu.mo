within PneumaticMuscle.Laws.Forces;
model Tondu "A constant factor on the strain, DY (1)-(2)"
  extends Empirical(k=1.1, final c_1=0, final c_2=0, final c_3=0, final c_4=0, final c_5=1);
  annotation (Documentation(info="<html>
<p>F = pi D0^2 P/4 (3 (1 - k eps)^2/tan(alpha_0)^2 - 1/sin(alpha_0)^2),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (1)-(2), after
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Tondu, Boitier and Lopez 1994</a>.</p>
</html>"));
end Tondu;

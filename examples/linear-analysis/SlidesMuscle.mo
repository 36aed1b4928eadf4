model SlidesMuscle "The muscle of the slides with a hanging load, and the friction of Kang's paper"
  extends PneumaticMuscle.Benches.VerticalLoad(
    muscle(D0=0.01, braid(c_3=0, c_5=1), redeclare model Friction = PneumaticMuscle.Laws.Frictions.CoulombViscous),
    load(m=3));
  annotation (Documentation(info="<html>
<p>AM, theoretical force equation 1; friction DP (5). Its coefficients and the load are for illustration.</p>
</html>"));
end SlidesMuscle;

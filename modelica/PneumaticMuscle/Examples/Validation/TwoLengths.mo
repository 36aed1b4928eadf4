within PneumaticMuscle.Examples.Validation;
model TwoLengths "Hysteresis of muscles of two lengths at two frequencies, AM Fig. 8"
  extends Icons.Validation;
  constant Types.Length L0[4] = {0.15, 0.30, 0.15, 0.30} "Lengths at rest";
  constant Real frequency[4](each unit="Hz") = {0.2, 0.2, 2, 2} "Frequencies of the pressure";
  output Types.GaugePressure p[4] = {3e5 - 2e5*cos(2*Constants.pi*frequency[i]*time) for i in 1:4} "Gauge pressures";
  output Types.Length x[4] = bench.x "Contractions";
  output Real eps[4](each unit="1") = bench.eps "Contraction ratios";
  Kang bench[4](p=p, muscle(L0=L0), each load(m=3)) "Muscles with hanging load"
    annotation (Placement(transformation(extent={{-20,-20},{20,20}})));
protected
  model Kang "The muscle of the slides with the friction of its source"
    extends Benches.VerticalLoad(muscle(D0=0.01, braid(c_3=0, c_5=1),
      redeclare model Friction = Laws.Frictions.CoulombViscous));
    annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equation 1; friction
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5).</p>
</html>"));
  end Kang;
  annotation (experiment(StopTime=10, Interval=0.005, Tolerance=1e-6), Documentation(info="<html>
<p>The slides show hysteresis for two lengths and say that the loop varies significantly with the frequency; neither
lengths, loads, frequencies nor axes can be read from the text. Force
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equation 1 (1 cm, 23 degrees, q =
1 + 3 exp(-2e-6 P)), friction Coulomb and viscous by the rate of strain,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5), as in Kang's paper that the slides build on;
its coefficients are for illustration. In contraction ratio the equation of motion knows the length only by its inertia,
M L eps_ddot: two lengths give one loop where the motion is slow.</p>
</html>"));
end TwoLengths;

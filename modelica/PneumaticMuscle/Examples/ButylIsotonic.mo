within PneumaticMuscle.Examples;
model ButylIsotonic "The isotonic bench with the butyl muscle"
  extends Benches.Isotonic(muscle(L0=data.L0, t_wall=data.t_wall, k_wall=data.k_wall, mu_fb=data.mu_fb, mu_d=data.mu_d),
    load(m=data.m));
  extends Icons.Example;
protected
  final parameter Muscles.Data.MuscleData data = Muscles.Data.Butyl() "Table of the paper";
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Benches.Isotonic</a> with the parameters of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 2.</p>
</html>"));
end ButylIsotonic;

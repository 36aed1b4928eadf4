within PneumaticMuscle.Muscles.Components;
model ButylMuscle "McKibben muscle of Doumit and Pardoel with a bladder of butyl rubber, DP Table 2"
  extends Muscle(L0=data.L0, D0=data.D0, turns=data.turns, fibres=data.fibres, t_wall=data.t_wall, k_wall=data.k_wall,
    mu_fb=data.mu_fb, mu_d=data.mu_d);
protected
  final parameter Data.MuscleData data = Data.Butyl() "Table of the paper";
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> find that its slow contraction is not explained
by friction: the elasticity of the thick bladder is missing
(<a href=\"modelica://PneumaticMuscle.Examples.Validation.ButylSlowRise\">Validation.ButylSlowRise</a>).</p>
</html>"));
end ButylMuscle;

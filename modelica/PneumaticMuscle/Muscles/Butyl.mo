within PneumaticMuscle.Muscles;
model Butyl "Muscle with a tube of butyl rubber, Doumit and Pardoel"
  extends Physical(usual=false, L0=data.L0, D0=data.D0, turns=data.turns, fibres=data.fibres, t_wall=data.t_wall,
    k_wall=data.k_wall,
    mu_fb=data.mu_fb, mu_d=data.mu_d);
protected
  final parameter Data.MuscleData data = Data.Butyl() "Table of the paper";
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 2,
<a href=\"modelica://PneumaticMuscle.Muscles.Data.Butyl\">Data.Butyl</a>.</p>
</html>"));
end Butyl;

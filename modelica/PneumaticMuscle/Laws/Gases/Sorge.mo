within PneumaticMuscle.Laws.Gases;
model Sorge "Polytropic filling of a volume that changes, DP (11)"
  extends Laws.Gases.PolytropicVesselGas;
  annotation (Documentation(info="<html>
<p>p_dot = n p/V ((G_in - G_out)/rho_0 (p_0/p)^(1/n) - V_dot),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (11) as printed, after
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sorge 2015</a>; differentiating p/p_0 = (rho/rho_0)^n with
rho = m/V confirms it. With rho_0 = p_0/(R T_0) and T = T_0 (p/p_0)^((n - 1)/n) it is V p_dot = n (R T (G_in - G_out) -
p V_dot): DP (66) with the work of the wall.</p>
</html>"));
end Sorge;

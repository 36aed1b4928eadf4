within PneumaticMuscle.Laws.Elasticities;
model PrintedSleeve "The stretched sleeve as printed, DY (12)"
  extends Interfaces.SleeveElasticity(final x_rest=L0*(1 - ((L_c + excitation.F_load/K)/L0)^(1/3)));
  parameter Real K(unit="N/m", min=100, max=1e7, nominal=1e5) = 3e4 "Coefficient of elasticity"
    annotation (Dialog(group="Law"));
  Real eps(unit="1") = x/L0 "Contraction ratio";
equation
  f = if eps <= (L0 - L_c)/L0 then K*(L_c - L0*(1 - eps)^3) else 0;
  annotation (Documentation(info="<html>
<p>F_elastic = K (L_o - L (1 - eps)^3) for eps up to (L - L_o)/L,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (12), and zero above. For L_o = L it is K L (1 - (1
- eps)^3) = K L (3 eps - 3 eps^2 + eps^3): zero at eps = 0 and a spring of stiffness 3 K about it, negative where the
muscle is stretched, so that it pulls the load up. For another L_o it jumps where it begins, by K L_o (1 - (L_o/L)^2);
with L_o below L it is positive down to eps = 1 - (L_o/L)^(1/3) and pushes the load down there, and with L_o above L a
load below K L_o ((L_o/L)^2 - 1) comes to rest on the jump itself.
<a href=\"modelica://PneumaticMuscle.Laws.Elasticities.StretchedSleeve\">StretchedSleeve</a> is the form without a jump.
With the default and L_o = L = 0.3 m, 300 N stretch the sleeve by 3.3 mm. DY identify K and print no value.</p>
</html>"));
end PrintedSleeve;

within PneumaticMuscle.Laws.Elasticities;
model StretchedSleeve "The stretched sleeve with the cube over the whole stretch, DY (12) modified"
  extends Interfaces.SleeveElasticity(final x_rest=L0 - L_c - (excitation.F_load/K)^(1/3));
  parameter Real K(unit="N/m3", min=1e6, max=1e13, nominal=1e10) = 1e10 "Coefficient of elasticity"
    annotation (Dialog(group="Law"));
protected
  Types.Length s = max(0, L0 - x - L_c) "Stretch";
equation
  f = -K*s^3;
  annotation (Documentation(info="<html>
<p>F_elastic = K (L_o - L (1 - eps))^3 for eps below (L - L_o)/L, zero above; the force pulls the load up.
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (12) prints K (L_o - L (1 - eps)^3), which
<a href=\"modelica://PneumaticMuscle.Laws.Elasticities.PrintedSleeve\">PrintedSleeve</a> is. For L_o = L the printed
form begins from zero too, as a spring of stiffness 3 K; for any other L_o it jumps at eps = (L - L_o)/L by K L_o (1 -
(L_o/L)^2), and for L_o below L its first part pushes the load down. With the bracket moved by one place force and slope
are continuous for every L_o. For L_o = L neither is wrong; they differ in how the sleeve stiffens. With the default,
300 N stretch the sleeve by 3.1 mm.</p>
</html>"));
end StretchedSleeve;

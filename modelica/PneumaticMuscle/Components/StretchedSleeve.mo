within PneumaticMuscle.Components;
model StretchedSleeve "What carries a load without pressure: the stretched sleeve, DY (12)"
  extends Interfaces.ForceElement;
  parameter Real K(unit="N/m3", min=1e6, max=1e13, nominal=1e10) = 1e10 "Coefficient of elasticity";
  parameter Types.Length L_o(min=0.01, max=2) = L0 "Length beyond which the sleeve stretches";
protected
  Types.Length s = max(0, L0 - x - L_o) "Stretch";
equation
  f = -K*s^3;
  annotation (Documentation(info="<html>
<p>F_elastic = K (L_o - L (1 - eps))^3 for eps below (L - L_o)/L, zero above; the force pulls the load up. DY (12)
prints K (L_o - L (1 - eps)^3), which jumps at eps = (L - L_o)/L, where it must begin from zero; with the bracket moved
by one place force and slope are continuous, and that is taken. L is the length from which contraction is counted,
L0 here. With the default, 300 N stretch the sleeve by 3.1 mm.</p>
</html>"));
end StretchedSleeve;

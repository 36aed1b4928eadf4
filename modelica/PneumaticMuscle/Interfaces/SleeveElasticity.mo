within PneumaticMuscle.Interfaces;
partial model SleeveElasticity "What carries a load without pressure, DY (12)"
  extends ForceElement;
  extends Icons.Elasticity;
  parameter Types.Length L_o(min=0, max=2) = 0 "Length from which the stretched sleeve carries; 0: the length at rest"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length x_rest "Contraction at which it carries the load of the run alone"
    annotation (Dialog(group="Geometry"));
  final parameter Types.Length L_c = if L_o > 0 then L_o else L0 "Length from which it carries";
  outer Excitation excitation "Load of the run";
equation
  assert(L_c > 0.8*L0 and L_c < 1.25*L0,
    "the length L_o from which the stretched sleeve carries must be 0.8 to 1.25 times L0");
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (12), (15), (16): it acts for eps up to (L -
L_o)/L, that is, where the muscle is longer than L_o. L is the length from which contraction is counted, L0 here. DY
call both L_o and L a length of the muscle and give neither; L_o = L is the sleeve that carries from its length at rest
on, and is what 0 stands for, so that L_o can be set in an FMU and goes with L0 where it is not.</p>
<p>Left to the extending class: the equation of f, and x_rest, where f = -F_load.</p>
</html>"));
end SleeveElasticity;

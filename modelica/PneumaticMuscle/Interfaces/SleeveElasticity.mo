within PneumaticMuscle.Interfaces;
partial model SleeveElasticity "What carries a load without pressure, DY (12)"
  extends ForceElement;
  parameter Types.Length L_o(min=0.01, max=2) = L0 "Length from which the stretched sleeve carries";
  parameter Types.Length x_rest "Contraction at which it carries the load of the run alone";
  outer Components.Excitation excitation "Load of the run";
equation
  assert(L_o > 0.8*L0 and L_o < 1.25*L0, "L_o, from which the stretched sleeve carries, goes with L0: set both");
  annotation (Documentation(info="<html>
<p>DY (12), (15), (16): it acts for eps up to (L - L_o)/L, that is, where the muscle is longer than L_o. L is the length
from which contraction is counted, L0 here. DY call both L_o and L a length of the muscle and give neither; L_o = L is the
sleeve that carries from its length at rest on. A bench gives L_o a number of its own, so that it can be set in an FMU:
whoever changes L0 there changes L_o with it.</p>
<p>Left to the extending class: the equation of f, and x_rest, where f = -F_load.</p>
</html>"));
end SleeveElasticity;

within PneumaticMuscle.Unknowns;
partial model ForceTerm "A further force between the ends of the muscle"
  extends Interfaces.ForceEffect;
  extends Icons.Unknown;
  Types.Force missing "Force, positive against contraction";
  Real eps(unit="1") "Contraction ratio";
equation
  f = missing;
  eps = x/L0;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of <code>missing</code>, as a function of contraction x or contraction
ratio eps, speed v and gauge pressure p_gauge. Its work is not given to the gas.</p>
</html>"));
end ForceTerm;

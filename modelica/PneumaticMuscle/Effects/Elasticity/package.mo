within PneumaticMuscle.Effects;
package Elasticity "Springs: what the bladder or the sleeve takes to be stretched"
  extends Icons.Elasticity;
  annotation (Documentation(info="<html>
<p>The family <code>elasticity</code>: a force that grows with the contraction and gives its work back.</p>
<p>Fingerprint: the contraction falls short, more so where it is larger, in filling and in holding alike and at every
speed; the pressure hardly changes. Members differ in how fast the error grows with the contraction.</p>
</html>"));
end Elasticity;

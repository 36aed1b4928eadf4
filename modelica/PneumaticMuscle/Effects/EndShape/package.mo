within PneumaticMuscle.Effects;
package EndShape "Ends that are not cylinders"
  extends Icons.EndShape;
  annotation (Documentation(info="<html>
<p>The family <code>end_shape</code>: another sleeve: pull and length at rest differ from those of a cylinder.</p>
<p>Fingerprint: pull and length at rest are wrong by a share that depends on the contraction, at rest as in motion, and
whichever way it was reached; the pressure hardly changes. Members differ in the contraction and the pressure at which
the share is large.</p>
</html>"));
end EndShape;

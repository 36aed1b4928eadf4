within PneumaticMuscle.Effects;
package DryFriction "Friction that does not care about the speed"
  extends Icons.DryFriction;
  annotation (Documentation(info="<html>
<p>The family <code>dry_friction</code>: a force against the motion whose size does not depend on the speed.</p>
<p>Fingerprint: the contraction lags in filling and in venting by the same force at every speed; contraction against
pressure is a loop whose width does not depend on the rate. Members differ in what happens after a reversal.</p>
</html>"));
end DryFriction;

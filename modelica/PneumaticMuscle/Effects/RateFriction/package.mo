within PneumaticMuscle.Effects;
package RateFriction "Friction that grows with the speed"
  extends Icons.RateFriction;
  annotation (Documentation(info="<html>
<p>The family <code>rate_friction</code>: a force against the motion that grows with the speed and vanishes at rest.</p>
<p>Fingerprint: the contraction lags while it moves and is right when it rests; the loop of contraction against pressure
widens with the rate. Members differ in the weight of speed, pressure, load and direction.</p>
</html>"));
end RateFriction;

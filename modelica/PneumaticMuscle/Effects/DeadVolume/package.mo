within PneumaticMuscle.Effects;
package DeadVolume "Gas volume in addition to that of the muscle or vessel"
  extends Icons.DeadVolume;
  annotation (Documentation(info="<html>
<p>The family <code>dead_volume</code>: a further volume at the pressure of the gas, behind an opening or not.</p>
<p>Fingerprint: filling and venting are slower by a factor that is largest while the muscle is long and its own volume
small; against a smaller area of the valves the beginning is slower than the end. The holds are right, but for a space
behind an opening.</p>
</html>"));
end DeadVolume;

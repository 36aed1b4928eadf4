within PneumaticMuscle.Effects;
package ValveArea "Another law of the opening of the valves"
  extends Icons.ValveArea;
  annotation (Documentation(info="<html>
<p>The family <code>valve_area</code>: another law of the effective areas by current, pressures and direction.</p>
<p>Fingerprint: filling, venting or both are wrong by a factor from the first moment on, another one at another current
or pressure; the holds are right. Members differ in what the factor depends on.</p>
</html>"));
end ValveArea;

within PneumaticMuscle.Effects;
package Leak "Gas that escapes"
  extends Icons.Leak;
  annotation (Documentation(info="<html>
<p>The family <code>leak</code>: a mass flow from the gas to the surroundings.</p>
<p>Fingerprint: the pressure falls while both valves are shut, rises more slowly in filling and settles below the
supply. Members differ in the law of the pressure.</p>
</html>"));
end Leak;

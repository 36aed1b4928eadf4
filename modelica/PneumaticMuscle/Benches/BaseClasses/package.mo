within PneumaticMuscle.Benches;
package BaseClasses "What several benches have in common: what feeds them, what they hold, how they are read"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>A bench extends <a href=\"modelica://PneumaticMuscle.Interfaces.Rig\">Interfaces.Rig</a> and those of these that it
needs, and joins them: each stands in its own part of the diagram, gas at the left, the muscle in the middle, readings
at the right. Names of components are those that data sets and models of users say, <code>load.m</code> or
<code>channel_p</code>.</p>
</html>"));
end BaseClasses;

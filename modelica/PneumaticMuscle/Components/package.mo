within PneumaticMuscle;
package Components "Muscle, vessel, valves, load and their parts"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Base models of DP, and what benches are put together from. The laws in them are in <code>Laws</code>.</p>
</html>"));
end Components;

within PneumaticMuscle;
package Components "Muscle, vessel, valves, load and their parts"
  annotation (Documentation(info="<html>
<p>Base models of DP, and what benches are put together from.</p>
</html>"));
end Components;

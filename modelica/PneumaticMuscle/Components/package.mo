within PneumaticMuscle;
package Components "Muscle, vessel, valves, load and their parts"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Base models of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>, and what benches are put together
from. The laws in them are in <a href=\"modelica://PneumaticMuscle.Laws\">Laws</a>.</p>
</html>"));
end Components;

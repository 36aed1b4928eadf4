within PneumaticMuscle.Pneumatics;
package Components "Sources, resistances, valves and vessels"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Base models of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>, of which the parts in
<a href=\"modelica://PneumaticMuscle.Pneumatics\">Pneumatics</a> and the benches are made. The laws in them are in
<a href=\"modelica://PneumaticMuscle.Laws\">Laws</a>.</p>
</html>"));
end Components;

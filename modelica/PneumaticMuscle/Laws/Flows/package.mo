within PneumaticMuscle.Laws;
package Flows "Mass flow rate through an opening"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Laws.Flows.Flow\">Flow</a> and is redeclared as the
<a href=\"modelica://PneumaticMuscle.Laws.Flows.Flow\">Flow</a> of a pair of valves.</p>
</html>"));
end Flows;

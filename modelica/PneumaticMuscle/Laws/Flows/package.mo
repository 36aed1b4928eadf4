within PneumaticMuscle.Laws;
package Flows "Mass flow rate through an opening"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Flow</code> and is redeclared as the <code>Flow</code> of a pair of valves.</p>
</html>"));
end Flows;

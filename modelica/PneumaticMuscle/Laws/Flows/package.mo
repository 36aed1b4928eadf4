within PneumaticMuscle.Laws;
package Flows "Mass flow rate through an opening"
  annotation (Documentation(info="<html>
<p>Each but one extends <code>Flow</code>; <code>IttoKogiso</code> extends <code>Interfaces.ValveArea</code> and is
redeclared as the <code>Area</code> of a pair of valves.</p>
</html>"));
end Flows;

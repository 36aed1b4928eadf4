within PneumaticMuscle.Laws;
package Valves "From commands to the openings of the valves"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>The dynamics extend <a href=\"modelica://PneumaticMuscle.Interfaces.ValveDrive\">Interfaces.ValveDrive</a>, the
effective areas <a href=\"modelica://PneumaticMuscle.Interfaces.ValveArea\">Interfaces.ValveArea</a>, the dynamics of
the openings behind them <a href=\"modelica://PneumaticMuscle.Interfaces.ValveOpening\">Interfaces.ValveOpening</a>;
each is redeclared as the <code>Drive</code>, the <code>Area</code> or the <code>Opening</code> of a pair of valves.</p>
</html>"));
end Valves;

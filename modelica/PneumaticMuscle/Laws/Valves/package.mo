within PneumaticMuscle.Laws;
package Valves "From commands to the openings of the valves"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>The dynamics extend <code>Interfaces.ValveDrive</code>, the effective areas <code>Interfaces.ValveArea</code>, the
dynamics of the openings behind them <code>Interfaces.ValveOpening</code>; each is redeclared as the <code>Drive</code>, the
<code>Area</code> or the <code>Opening</code> of a pair of valves.</p>
</html>"));
end Valves;

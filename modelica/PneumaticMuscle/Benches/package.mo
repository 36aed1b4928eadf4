within PneumaticMuscle;
package Benches "Test rigs: what is driven, what is measured"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>A bench has plain inputs, outputs and parameters, in SI units; pressures in its signals are gauge pressures. Each
becomes an FMU. It extends <a href=\"modelica://PneumaticMuscle.Interfaces.Rig\">Interfaces.Rig</a> and, of
<a href=\"modelica://PneumaticMuscle.Benches.BaseClasses\">BaseClasses</a>, what it shares with others.</p>
</html>"));
end Benches;

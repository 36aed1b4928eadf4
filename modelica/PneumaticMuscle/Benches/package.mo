within PneumaticMuscle;
package Benches "Test rigs: what is driven, what is measured"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>A bench has plain inputs, outputs and parameters, in SI units; pressures in its signals are gauge pressures. Each
becomes an FMU.</p>
</html>"));
end Benches;

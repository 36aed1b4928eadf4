within PneumaticMuscle.Instruments;
package Sensors "What instruments read"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Transducers without load; instruments with faults of their own are among the effects.</p>
</html>"));
end Sensors;

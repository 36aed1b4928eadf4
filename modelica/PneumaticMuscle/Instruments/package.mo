within PneumaticMuscle;
package Instruments "What can be read in a rig: transducers, each with its measuring channel"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.Instrument\">Interfaces.Instrument</a>; its output is
the signal of the rig. Transducers and channels are those of
<a href=\"modelica://PneumaticMuscle.Instruments.Sensors\">Sensors</a>, and an effect that is a fault of an instrument
takes their place.</p>
</html>"));
end Instruments;

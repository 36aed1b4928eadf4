within PneumaticMuscle;
package Instruments "What can be read in a rig: transducers, each with its measuring channel"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.Instrument</code>; its output is the signal of the rig. Transducers and channels are those of
<code>Sensors</code>, and an effect that is a fault of an instrument takes their place.</p>
</html>"));
end Instruments;

within PneumaticMuscle.Effects;
package Saturation "A reading that ends at a limit"
  extends Icons.Saturation;
  annotation (Documentation(info="<html>
<p>The family <code>saturation</code>: a record that goes with its signal up or down to a limit, and no further.</p>
<p>Fingerprint: one reading is flat where the signal must have gone on; below the limit, and in all other readings,
nothing is wrong. The noise ends at the limit too where it is that of the recorder.</p>
</html>"));
end Saturation;

within PneumaticMuscle.Effects;
package PressureOffset "A pressure transducer that is out of true"
  extends Icons.PressureOffset;
  annotation (Documentation(info="<html>
<p>The family <code>pressure_offset</code>: the reading of the transducer against the pressure of the gas.</p>
<p>Fingerprint: the pressure is off by an amount that follows from the pressure alone, before the start too; contraction
and temperature are right. Members differ in the curve.</p>
</html>"));
end PressureOffset;

within PneumaticMuscle.Effects;
package Creep "Rubber and fibres that give way late"
  extends Icons.Creep;
  annotation (Documentation(info="<html>
<p>The family <code>creep</code>: a force of the contraction and its past, which relaxes in a hold.</p>
<p>Fingerprint: after a fast change the contraction goes on creeping in the hold while the pressure rests. Members
differ in the times after which the creep is over.</p>
</html>"));
end Creep;

within PneumaticMuscle;
package Mechanics "What a muscle pulls in a rig"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.Mechanics</code>; <code>pam-cosim bench</code> joins one with <code>Pneumatics</code>. Positions
are contractions: positive as the muscle shortens, zero at its length at rest.</p>
</html>"));
end Mechanics;

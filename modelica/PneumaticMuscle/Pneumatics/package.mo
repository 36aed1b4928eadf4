within PneumaticMuscle;
package Pneumatics "What feeds a muscle in a rig"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.Pneumatics</code>; <code>pam-cosim bench</code> joins one with <code>Mechanics</code>.</p>
</html>"));
end Pneumatics;

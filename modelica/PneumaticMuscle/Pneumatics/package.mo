within PneumaticMuscle;
package Pneumatics "What feeds a muscle in a rig"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.Pneumatics\">Interfaces.Pneumatics</a>; <code>pam-cosim
bench</code> joins one with <a href=\"modelica://PneumaticMuscle.Mechanics\">Mechanics</a>. They are made of
<a href=\"modelica://PneumaticMuscle.Pneumatics.Components\">Components</a>.</p>
</html>"));
end Pneumatics;

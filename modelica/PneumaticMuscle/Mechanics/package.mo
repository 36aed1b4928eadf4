within PneumaticMuscle;
package Mechanics "What a muscle pulls in a rig"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.Mechanics\">Interfaces.Mechanics</a>; <code>pam-cosim
bench</code> joins one with <a href=\"modelica://PneumaticMuscle.Pneumatics\">Pneumatics</a>. Positions are
contractions: positive as the muscle shortens, zero at its length at rest. They are made of
<a href=\"modelica://PneumaticMuscle.Mechanics.Components\">Components</a>.</p>
</html>"));
end Mechanics;

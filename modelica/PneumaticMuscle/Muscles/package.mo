within PneumaticMuscle;
package Muscles "Muscles as a rig holds them, with their fixed end and where they hang without pressure"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.RigMuscle\">Interfaces.RigMuscle</a>; one of other
geometry extends one of these. A muscle that is known by a name is called so here, with its measures in
<a href=\"modelica://PneumaticMuscle.Muscles.Data\">Data</a>. The muscles themselves, held by nothing, are in
<a href=\"modelica://PneumaticMuscle.Muscles.Components\">Components</a>.</p>
</html>"));
end Muscles;

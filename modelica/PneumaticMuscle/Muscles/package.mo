within PneumaticMuscle;
package Muscles "Muscles as a rig holds them, with their fixed end and where they hang without pressure"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.RigMuscle</code>; one of other geometry extends one of these. A muscle
that is known by a name is called so here, with its measures in <code>Data</code>.</p>
</html>"));
end Muscles;

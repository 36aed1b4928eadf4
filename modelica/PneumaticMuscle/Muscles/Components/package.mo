within PneumaticMuscle.Muscles;
package Components "Muscles between two flanges and a gas port, held by nothing"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Of these the parts in <a href=\"modelica://PneumaticMuscle.Muscles\">Muscles</a> and the benches are made: the
muscles of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> and
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a>. The laws in them are in
<a href=\"modelica://PneumaticMuscle.Laws\">Laws</a>.</p>
</html>"));
end Components;

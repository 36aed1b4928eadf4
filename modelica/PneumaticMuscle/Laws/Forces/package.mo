within PneumaticMuscle.Laws;
package Forces "Pulling force by pressure and length"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.Braid\">Interfaces.Braid</a> and is redeclared as the
<code>Braid</code> of a muscle. The laws of the pull alone (Empirical and what extends it, Reynolds, Cao) keep the
volume of a cylinder, as their authors do; the work that they do is then not the work that the gas gives.</p>
</html>"));
end Forces;

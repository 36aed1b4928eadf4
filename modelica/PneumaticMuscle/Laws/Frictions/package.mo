within PneumaticMuscle.Laws;
package Frictions "Friction by speed, pressure and load"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.ForceElement\">Interfaces.ForceElement</a> and lies in
parallel with the sleeve. The members of
<a href=\"modelica://PneumaticMuscle.Effects.DryFriction\">Effects.DryFriction</a> and
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction\">Effects.RateFriction</a> have the same signature.</p>
</html>"));
end Frictions;

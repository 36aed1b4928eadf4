within PneumaticMuscle.Laws;
package Frictions "Friction by speed, pressure and load"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.ForceElement</code> and lies in parallel with the sleeve. The members of
<code>Effects.DryFriction</code> and <code>Effects.RateFriction</code> have the same signature.</p>
</html>"));
end Frictions;

within PneumaticMuscle.Laws;
package Frictions "Friction by speed, pressure and load"
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.ForceElement</code> and lies in parallel with the sleeve. Effects.CoulombFriction,
ViscousFriction, DahlFriction and MaxwellSlipFriction, DP (12), have the same signature.</p>
</html>"));
end Frictions;

within PneumaticMuscle.Laws.Frictions;
model BladderFriction "Friction between fibres and bladder, DP (71)"
  extends Interfaces.ForceElement;
  extends Icons.DryFriction;
  parameter Types.Area A_fb "Area of contact between fibres and bladder" annotation (Dialog(group="Geometry"));
  parameter Real mu_fb(unit="1") "Coefficient of friction" annotation (Dialog(group="Friction"));
equation
  f = p_gauge*mu_fb*A_fb;
  annotation (Documentation(info="<html>
<p>Printed as a constant that opposes contraction, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(17) and (71), whichever way the muscle moves.</p>
</html>"));
end BladderFriction;

within PneumaticMuscle.Laws.Frictions;
model FibreFriction "Friction of fibre on fibre, DP (68)-(69)"
  extends Interfaces.ForceElement;
  extends Icons.DryFriction;
  parameter Types.Area A_ff "Area of all crossings of fibres" annotation (Dialog(group="Geometry"));
  parameter Real mu_d(unit="1") "Coefficient of dynamic friction" annotation (Dialog(group="Friction"));
  parameter Real K_f(unit="s/m") "Steepness of the friction curve" annotation (Dialog(group="Friction"));
equation
  f = p_gauge*A_ff*mu_d*tanh(K_f*v);
  annotation (Documentation(info="<html>
<p>f_ff = p_gauge A_ff mu_d tanh(K_f v), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (68)-(69),
with A_ff = q w z for all q crossings, DP (70) and (72). With K_f = 1 s/m, DP's value, it is viscous at the speeds of a
muscle.</p>
</html>"));
end FibreFriction;

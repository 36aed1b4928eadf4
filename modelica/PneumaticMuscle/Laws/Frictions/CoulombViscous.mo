within PneumaticMuscle.Laws.Frictions;
model CoulombViscous "Coulomb and viscous friction by the rate of strain, DP (5), DY (8)-(9)"
  extends Interfaces.ForceElement;
  extends Icons.RateFriction;
  parameter Types.Force c_c(min=0, max=500) = 5 "Coulomb friction" annotation (Dialog(group="Law"));
  parameter Real c_v(unit="N.s", min=0, max=1e4) = 20 "Viscous friction per rate of strain"
    annotation (Dialog(group="Law"));
  parameter Real rate_smooth(unit="1/s", min=1e-6, max=0.1) = 2e-3 "Rate of strain over which the sign is rounded"
    annotation (Dialog(group="Law"));
  Real eps_dot(unit="1/s") = v/L0 "Rate of strain";
equation
  f = c_v*eps_dot + c_c*tanh(v_slip/L0/rate_smooth);
  annotation (Documentation(info="<html>
<p>F = c_v eps_dot + c_c sgn(eps_dot), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (5),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (8)-(9). The sign is smoothed as DP (69) does, over
0.2 % of the length a second.</p>
</html>"));
end CoulombViscous;

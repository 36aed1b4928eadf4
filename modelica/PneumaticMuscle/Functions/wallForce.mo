within PneumaticMuscle.Functions;
function wallForce "What a stiff wall takes of a cylinder's pull"
  extends Icons.Function;
  input Types.GaugePressure p_gauge "Gauge pressure";
  input Types.Length x "Contraction";
  input Types.Length L0 "Length at rest";
  input Types.Length D0 "Diameter of the sleeve at rest";
  input Real turns "Turns of a fibre";
  input Types.GaugePressure p_0 "Threshold pressure (gauge) at full length";
  input Types.Pressure p_w "Pressure loss of the wall after it has bent open";
  input Real eps_w "Contraction ratio over which the wall bends open";
  output Types.Force f "Force that opposes contraction";
protected
  constant Types.Force F_smooth = 0.1 "Force over which the pull ends";
  Real n_2 "Divides the square of a length to give an area of pull";
  Types.Area A_0 "Pull by pressure at full length";
  Real eps "Contraction ratio";
  Types.Force F_sleeve "Pull of the cylinder";
  Types.Force F_wall "What the wall takes where there is as much";
algorithm
  n_2 := 4*Constants.pi*turns^2;
  A_0 := (2*L0^2 - (turns*Constants.pi*D0)^2)/n_2;
  eps := x/L0;
  F_sleeve := p_gauge*(A_0 + 3*x*(x - 2*L0)/n_2);
  F_wall := A_0*(p_0 + p_w*(1 - exp(-max(eps, 0)/eps_w) + min(eps, 0)/eps_w));
  f := F_sleeve - slackMax(F_sleeve - F_wall, F_smooth);
  annotation (Documentation(info="<html>
<p>f = min(p_gauge A(L), A(L0) (p_0 + p_w (1 - exp(-eps/eps_w)))), A(L) = (3 L^2 - b^2)/(4 pi n^2), L = L0 - x: no more
than the cylinder pulls, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), so that the muscle
never pushes. A muscle longer than at rest has the wall's stiffness at rest.</p>
<p>The exponential is what formulas that are fitted to fluidic muscles have in common: a force without pressure that
comes within a few percent of contraction and then stays, (a_2 exp(a_3 eps) + a_6) of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sarosi 2012</a>, c_0 (exp(-c_1 e) - 1) of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others 2026</a>. Neither names a cause; that it
is the thick wall, which must be bent open, is a reading. p_0 is the threshold of pressure.</p>
</html>"));
end wallForce;

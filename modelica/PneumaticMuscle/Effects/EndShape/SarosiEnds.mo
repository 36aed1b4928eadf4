within PneumaticMuscle.Effects.EndShape;
model SarosiEnds
  "The pull of a fluidic muscle: linear in pressure, exponential and linear in contraction, never below zero"
  extends Interfaces.PullingSleeve;
  extends FamilyMember;
  parameter Real a_5(unit="1", min=0.2, max=3, nominal=1) = 1 "Pull at full length, by the cylinder's"
    annotation (Dialog(group="Effect"));
  parameter Real a_4(unit="1", min=1, max=10, nominal=3) = 3.3 "Linear loss with contraction"
    annotation (Dialog(group="Effect"));
  parameter Real a_1(unit="1", min=-0.5, max=0.5, nominal=0.1) = 0 "Initial loss"
    annotation (Dialog(group="Effect"));
  parameter Types.GaugePressure p_0(min=-1e5, max=5e5, nominal=3e4) = 0.3e5 "Pressure loss at full length"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure p_w(min=0, max=1e6, nominal=1e5) = 1e5 "Further initial pressure loss"
    annotation (Dialog(group="Effect"));
  parameter Real eps_w(unit="1", min=0.005, max=0.06, nominal=0.01) = 0.03 "Contraction ratio of the initial loss"
    annotation (Dialog(group="Effect"));
protected
  constant Real eps_end(unit="1") = 0.425 "Contraction beyond all that a muscle reaches, where the pull ends";
  final parameter Types.Area A_0 = (3*L0^2 - b^2)/(4*Constants.pi*turns^2)
    "Pull of the cylinder at full length by pressure";
  Real gone(unit="1") = exp(-max(eps, 0)/eps_w) - min(eps, 0)/eps_w "1 at full length, 0 where the exponential is gone";
equation
  F_law = A_0*((a_1*p_gauge + p_w)*gone + p_gauge*(a_5 - a_1 - a_4*eps)/(1 + (eps/eps_end)^24) - p_w - p_0);
  annotation (Documentation(info="<html>
<p>F = max(0, (c_1 p + c_2) exp(c_3 eps) + c_4 p eps + c_5 p + c_6), Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sarosi 2012</a>,
<a href=\"modelica://PneumaticMuscle.Laws.Forces.Sarosi\">Laws.Forces.Sarosi</a>, with coefficients by the pull A of the
cylinder at full length, so that they are of one size for all muscles: c_1 = A a_1, c_2 = A p_w, c_3 = -1/eps_w, c_4 =
-A a_4, c_5 = A (a_5 - a_1), c_6 = -A (p_w + p_0). Typical for fluidic muscles of 10 and 20 mm: a_5 1.0 to 1.1, a_4 3.4,
a_1 near 0, p_0 40 kPa, p_w 80 to 200 kPa, eps_w 0.015 to 0.035. Beyond 40 % of contraction the pull ends, as in
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.FlexibleEnds\">FlexibleEnds</a>. It leaves 4.3 N rms of Table A1
of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, 1654 N, and 1.3 N of Table
A2, 542 N. The volume keeps the cylinder's law. No set of values gives the base law back.</p>
<p>Fingerprint: as StiffWall; beyond the first percent the pull falls in a straight line with contraction.</p>
</html>"));
end SarosiEnds;

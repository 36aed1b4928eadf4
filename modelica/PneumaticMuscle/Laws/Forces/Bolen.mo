within PneumaticMuscle.Laws.Forces;
model Bolen "Pull by relative pressure and relative contraction, scaled by what a muscle of this length pulls"
  extends Interfaces.PullingSleeve;
  parameter Types.GaugePressure p_620(min=1e5, max=1e6) = 620e3 "Gauge pressure by which pressures are divided"
    annotation (Dialog(group="Law"));
  parameter Real eps_620(unit="1", min=0.05, max=0.4) = 0.17
    "Contraction ratio without load at that pressure, to be measured"
    annotation (Dialog(group="Law"));
  parameter Types.Force b_1(min=1, max=1e4) = 303.5 "Scale of the pull" annotation (Dialog(group="Law"));
  parameter Real b_2(unit="1/m", min=0.1, max=1e3) = 19.03 "How soon it is reached with length"
    annotation (Dialog(group="Law"));
  parameter Types.Length l_caps(min=0, max=0.1, nominal=1e-2) = 0.0075 "Length at which the end caps meet"
    annotation (Dialog(group="Law"));
  parameter Real c_0(unit="1", min=0, max=3) = 0.5682 "What the contraction takes, by the pull at p_620"
    annotation (Dialog(group="Law"));
  parameter Real c_1(unit="1", min=0, max=50) = 4.254 "How soon it takes it" annotation (Dialog(group="Law"));
  parameter Real c_2(unit="1", min=0, max=20) = 0.5597 "How soon the effect of pressure falls with contraction"
    annotation (Dialog(group="Law"));
protected
  final parameter Types.Force F_620 = b_1*atan(b_2*(L0 - l_caps)) "Pull at rest and p_620";
  Real e(unit="1") = eps/eps_620 "Relative contraction";
equation
  F_law = F_620*(c_0*(exp(-c_1*max(e, 0)) - 1 - c_1*min(e, 0)) + p_gauge/p_620*exp(-c_2*e^2));
  annotation (Documentation(info="<html>
<p>F = F_620 (c_0 (exp(-c_1 e) - 1) + p/p_620 exp(-c_2 e^2)), zero where that is negative, with e = eps/eps_620 and
F_620 = b_1 arctan(b_2 (L0 - l_caps)), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others
2026</a>, their equations for the normalised force and the maximum force. L0 is the length between the hose clamps. For
muscles longer than at rest the first term goes on with its slope there.</p>
<p>Defaults: fluidic muscles of 10 mm. For 20 mm: b_1 = 922.4 N, b_2 = 15.37 1/m, l_caps = 0.013 m, c_0 = 0.2579, c_1 =
6.477, c_2 = 1.321. eps_620 differs from muscle to muscle and must be measured; 0.149 to 0.175 for the six of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Hunt, Graber-Tilton and Quinn 2017</a>. Of the two maximum
forces that the paper works out, 335.3 N for 112 mm is what its equation gives, 230 N for 54 mm is not: 219.9 N.</p>
</html>"));
end Bolen;

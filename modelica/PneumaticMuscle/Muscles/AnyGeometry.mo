within PneumaticMuscle.Muscles;
model AnyGeometry "Muscle of Doumit and Pardoel by any measures that determine its sleeve"
  extends Physical(usual=false, final L0=L, final D0=D, final turns=n, final t_wall=sleeve.t_wall,
    fibres(min=0) = 0,
    final N=if fibres > 0 then fibres else dp.fibres*(L0*D0/sqrt(L0^2 + (turns*Constants.pi*D0)^2)/w)
      /(dp.L0*dp.D0/sqrt(dp.L0^2 + (dp.turns*Constants.pi*dp.D0)^2)/dp.t_fibre));
  replaceable record Sleeve = Data.SleeveData(L0=0.24, D0=0.02, turns=2) constrainedby Data.SleeveData
    "Measures of the sleeve"
    annotation (choicesAllMatching=true);
  Sleeve sleeve "Measures of the sleeve; three of L0, D0, turns, b and alpha_0, the others zero";
protected
  constant Real tolerance(unit="1") = 0.02 "How far measures may disagree";
  final parameter Data.MuscleData dp = Data.Latex() "Muscle of DP Table 1, whose fibres fill the usual share";
  constant Real least = 1e-9 "Keeps what is not stated out of denominators";
  final parameter Real stated = (if sleeve.L0 > 0 then 1 else 0) + (if sleeve.D0 > 0 then 1 else 0)
    + (if sleeve.turns > 0 then 1 else 0) + (if sleeve.b > 0 then 1 else 0) + (if sleeve.alpha_0 > 0 then 1 else 0)
    "Number of measures that are stated";
  final parameter Types.Length L_s = max(sleeve.L0 - sleeve.fittings, 0) "What of the stated length contracts";
  final parameter Types.Length around = sleeve.turns*Constants.pi*sleeve.D0
    "Way of a fibre about the muscle, if stated";
  final parameter Real alpha(unit="rad") = max(1e-3, if sleeve.alpha_0 > 0 then sleeve.alpha_0
    else if sleeve.b > 0 and L_s > 0 then acos(min(1, L_s/max(sleeve.b, least)))
    else if sleeve.b > 0 then asin(min(1, around/max(sleeve.b, least)))
    else atan(around/max(L_s, least))) "Angle between fibres and axis";
  final parameter Types.Length L = if L_s > 0 then L_s else if sleeve.b > 0 then sleeve.b*cos(alpha)
    else around/tan(alpha)
    "Length that contracts";
  final parameter Types.Length D = if sleeve.D0 > 0 then sleeve.D0
    else L*tan(alpha)/(Constants.pi*max(sleeve.turns, least))
    "Diameter of the fibres";
  final parameter Real n(unit="1") = if sleeve.turns > 0 then sleeve.turns
    else L*tan(alpha)/(Constants.pi*max(sleeve.D0, least))
    "Turns of a fibre";
equation
  assert(stated > 2.5 and (sleeve.D0 > 0 or sleeve.turns > 0),
    "the sleeve is not determined: state three of L0, D0, turns, b and alpha_0, with D0 or turns among them; "
    + "stated are L0 = "
    + String(sleeve.L0) + " m, D0 = " + String(sleeve.D0) + " m, turns = " + String(sleeve.turns) + ", b = "
    + String(sleeve.b) + " m, alpha_0 = " + String(sleeve.alpha_0) + " rad (0: not stated)");
  assert(sleeve.fittings < sleeve.L0 or sleeve.L0 <= 0 and sleeve.fittings <= 0,
    "fittings are a part of L0: state L0, and fittings shorter than that");
  assert(abs(n*Constants.pi*D - L*tan(alpha)) < tolerance*L*tan(alpha)
    and abs(L - (if sleeve.b > 0 then sleeve.b*cos(alpha) else L)) < tolerance*L,
    "the measures of the sleeve contradict each other: "
    + "L0 - fittings = b cos(alpha_0) and turns pi D0 = b sin(alpha_0), "
    + "but stated are L0 = " + String(sleeve.L0) + " m, fittings = " + String(sleeve.fittings) + " m, D0 = "
    + String(sleeve.D0) + " m, turns = " + String(sleeve.turns) + ", b = " + String(sleeve.b) + " m, alpha_0 = "
    + String(sleeve.alpha_0) + " rad; set to 0 what shall follow from the others");
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>L0 - fittings = b cos(alpha_0), n pi D0 = b sin(alpha_0), the cylinder of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1): <code>sleeve</code> states any three of L0, D0,
turns, b and alpha_0 with D0 or turns among them, and the others, which are zero, follow. More may be stated if they
agree within 2 %; the angle is then taken from alpha_0 before b, and from b before turns. A run ends at its start with a
message where they do not agree, or do not determine the sleeve.</p>
<p>A fibre of width w at alpha_0 to the axis takes w/cos(alpha_0) of the circumference; the N/2 fibres of one
direction fill the share f = N w/(2 pi D0 cos(alpha_0)) of it. Unless <code>fibres</code> states N (0: not stated), f
is assumed to be that of the muscle of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 1,
0.49, where N = 216; N need not be a whole number. By DP (46)-(48) the fibres then cover 2 f - f^2 sin(alpha_0)
cos(alpha_0) z/w &lt; 1 of any sleeve. A run warns where fibres that are stated cover more.</p>
<p>Fittings count in the length that a ruler measures and do not contract: the contraction ratio is that of the rest. In
a muscle whose fittings are not known the effect
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.TonduEnds\">TonduEnds</a> finds them, fittings = L0 (1 - 1/k).</p>
</html>"));
end AnyGeometry;

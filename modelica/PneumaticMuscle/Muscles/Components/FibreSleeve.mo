within PneumaticMuscle.Muscles.Components;
partial model FibreSleeve "A sleeve of crossed fibres with its friction; default parameters: DP Table 1"
  extends Interfaces.MuscleTerminals(L0=0.24, D0=0.02, turns=2, t_wall=0.254e-3);
  extends Icons.Muscle;
  parameter Real fibres(unit="1", min=1, max=1000) = 216 "Number of fibres in the sleeve (N)"
    annotation (Dialog(group="Geometry"));
  parameter Real mu_fb(unit="1", min=0, max=1) = 0.015 "Coefficient of friction between fibres and bladder"
    annotation (Dialog(group="Friction"));
  parameter Real mu_d(unit="1", min=0, max=5) = 0.8 "Coefficient of dynamic friction of fibre on fibre"
    annotation (Dialog(group="Friction"));
  parameter Real K_f(unit="s/m", min=0, max=1e4) = 1 "Steepness of the fibre friction curve"
    annotation (Dialog(group="Friction"));
  parameter Types.Length w(min=1e-5, max=0.01) = 0.254e-3 "Width of a fibre" annotation (Dialog(group="Geometry"));
  parameter Types.Length z(min=1e-5, max=0.01) = 0.254e-3 "Length of a crossing along a fibre"
    annotation (Dialog(group="Geometry"));
  replaceable model Braid = Laws.Forces.CylindricalBraid constrainedby Interfaces.Braid "Law of the sleeve"
    annotation (choicesAllMatching=true);
  Braid braid(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Sleeve"
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  Laws.Frictions.FibreFriction fibreFriction(L0=L0, D0=D0, turns=turns, t_wall=t_wall, A_ff=crossings*w*z, mu_d=mu_d,
    K_f=K_f)
    "Friction of fibre on fibre"
    annotation (Placement(transformation(extent={{20,-10},{40,10}})));
  Laws.Frictions.BladderFriction bladderFriction(L0=L0, D0=D0, turns=turns, t_wall=t_wall, A_fb=A_fibre, mu_fb=mu_fb)
    "Friction between fibres and bladder"
    annotation (Placement(transformation(extent={{50,-10},{70,10}})));
protected
  parameter Real N(unit="1") = fibres "Number of fibres that friction and heat are calculated with";
  final parameter Real crossings = 2*turns*(N/2)^2 - N/2 "Number of crossings (q), DP (47)";
  final parameter Types.Area A_fibre = w*(N*sqrt(L0^2 + (turns*Constants.pi*D0)^2) - z*crossings/2)
    "Area of contact between fibres and bladder, DP (48)";
  Types.Area A_q = max(0, Constants.pi*braid.D*braid.L - A_fibre) "Area that exchanges heat with the gas";
equation
  assert(A_fibre >= 0 and A_fibre < Constants.pi*D0*L0,
    "the fibres do not fit on the sleeve: by DP (48) they cover " + String(1e4*A_fibre) + " cm2 of "
    + String(1e4*Constants.pi*D0*L0) + " cm2, so that no heat passes; state fibres, w and z",
    AssertionLevel.warning);
  connect(port, braid.port)
    annotation (Line(points={{-100,0}, {-10,0}}, color={0,90,160}));
  connect(port, fibreFriction.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {15,15}, {15,0}, {20,0}}, color={0,90,160}));
  connect(port, bladderFriction.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {45,15}, {45,0}, {50,0}}, color={0,90,160}));
  connect(flange_a, braid.flange_a)
    annotation (Line(points={{0,-100}, {0,-10}}, color={0,110,60}));
  connect(flange_a, fibreFriction.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {30,-15}, {30,-10}}, color={0,110,60}));
  connect(flange_a, bladderFriction.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {60,-15}, {60,-10}}, color={0,110,60}));
  connect(flange_b, braid.flange_b)
    annotation (Line(points={{0,100}, {0,10}}, color={0,110,60}));
  connect(flange_b, fibreFriction.flange_b)
    annotation (Line(points={{0,100}, {0,19}, {30,19}, {30,10}}, color={0,110,60}));
  connect(flange_b, bladderFriction.flange_b)
    annotation (Line(points={{0,100}, {0,19}, {60,19}, {60,10}}, color={0,110,60}));
  annotation (Documentation(info="<html>
<p>Force <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), friction DP (68)-(71), geometry as in
<a href=\"modelica://PneumaticMuscle.Interfaces.Braid\">Interfaces.Braid</a>. The area that exchanges heat is what the
fibres leave free, DP (46)-(49), A_q = max(0, pi D L - w (b N - z q/2)), q = 2 n (N/2)^2 - N/2; w and z are not
tabulated, the fibre thickness is taken for both. A run warns where the fibres cover more than the sleeve at rest.</p>
<p>Left to the extending class: the gas. The port is a pressure tap as far as the sleeve goes.</p>
</html>"));
end FibreSleeve;

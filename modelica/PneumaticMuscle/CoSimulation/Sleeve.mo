within PneumaticMuscle.CoSimulation;
model Sleeve "A muscle without its gas: braid and friction; default parameters as Components.Muscle"
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
  Types.Area A "Area that exchanges heat with the gas";
protected
  final parameter Real crossings = 2*turns*(fibres/2)^2 - fibres/2 "Number of crossings (q), DP (47)";
  final parameter Types.Area A_fibre = w*(fibres*sqrt(L0^2 + (turns*Constants.pi*D0)^2) - z*crossings/2)
    "Area of contact between fibres and bladder, DP (48)";
public
  Braid braid(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Sleeve"
    annotation (Placement(transformation(extent={{-15,-15},{15,15}})));
  Laws.Frictions.FibreFriction fibreFriction(L0=L0, D0=D0, turns=turns, t_wall=t_wall, A_ff=crossings*w*z, mu_d=mu_d,
    K_f=K_f)
    "Friction of fibre on fibre"
    annotation (Placement(transformation(extent={{25,-15},{55,15}})));
  Laws.Frictions.BladderFriction bladderFriction(L0=L0, D0=D0, turns=turns, t_wall=t_wall, A_fb=A_fibre, mu_fb=mu_fb)
    "Friction between fibres and bladder"
    annotation (Placement(transformation(extent={{65,-15},{95,15}})));
equation
  A = max(0, Constants.pi*braid.D*braid.L - A_fibre);
  connect(port, braid.port)
    annotation (Line(points={{-100,0}, {-15,0}}, color={0,90,160}));
  connect(port, fibreFriction.port)
    annotation (Line(points={{-100,0}, {-20,0}, {-20,20}, {20,20}, {20,0}, {25,0}}, color={0,90,160}));
  connect(port, bladderFriction.port)
    annotation (Line(points={{-100,0}, {-20,0}, {-20,20}, {60,20}, {60,0}, {65,0}}, color={0,90,160}));
  connect(flange_a, braid.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}}, color={0,110,60}));
  connect(flange_a, fibreFriction.flange_a)
    annotation (Line(points={{0,-100}, {0,-20}, {40,-20}, {40,-15}}, color={0,110,60}));
  connect(flange_a, bladderFriction.flange_a)
    annotation (Line(points={{0,-100}, {0,-20}, {80,-20}, {80,-15}}, color={0,110,60}));
  connect(flange_b, braid.flange_b)
    annotation (Line(points={{0,100}, {0,15}}, color={0,110,60}));
  connect(flange_b, fibreFriction.flange_b)
    annotation (Line(points={{0,100}, {0,24}, {40,24}, {40,15}}, color={0,110,60}));
  connect(flange_b, bladderFriction.flange_b)
    annotation (Line(points={{0,100}, {0,24}, {80,24}, {80,15}}, color={0,110,60}));
  annotation (Documentation(info="<html>
<p>Force <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), friction DP (68)-(71), area of the
wall DP (48), as in <a href=\"modelica://PneumaticMuscle.Muscles.Components.Muscle\">Components.Muscle</a>. The port is
a pressure tap: the gas is in another model.</p>
</html>"));
end Sleeve;

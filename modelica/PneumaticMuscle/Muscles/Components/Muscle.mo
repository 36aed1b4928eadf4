within PneumaticMuscle.Muscles.Components;
model Muscle "McKibben muscle of Doumit and Pardoel; default parameters: latex bladder, DP Table 1"
  extends Interfaces.MuscleTerminals(L0=0.24, D0=0.02, turns=2, t_wall=0.254e-3);
  extends Icons.Muscle;
  parameter Real fibres(unit="1", min=1, max=1000) = 216 "Number of fibres in the sleeve (N)"
    annotation (Dialog(group="Geometry"));
  parameter Real n_g(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  parameter Real mu_fb(unit="1", min=0, max=1) = 0.015 "Coefficient of friction between fibres and bladder"
    annotation (Dialog(group="Friction"));
  parameter Real mu_d(unit="1", min=0, max=5) = 0.8 "Coefficient of dynamic friction of fibre on fibre"
    annotation (Dialog(group="Friction"));
  parameter Real K_f(unit="s/m", min=0, max=1e4) = 1 "Steepness of the fibre friction curve"
    annotation (Dialog(group="Friction"));
  parameter Types.ThermalConductivity k_wall(min=0.01, max=10) = 0.14 "Thermal conductivity of the bladder"
    annotation (Dialog(group="Heat"));
  parameter Types.CoefficientOfHeatTransfer h_film(min=0.1, max=1000) = 20
    "Film coefficient on both sides of the bladder"
    annotation (Dialog(group="Heat"));
  parameter Types.Length w(min=1e-5, max=0.01) = 0.254e-3 "Width of a fibre" annotation (Dialog(group="Geometry"));
  parameter Types.Length z(min=1e-5, max=0.01) = 0.254e-3 "Length of a crossing along a fibre"
    annotation (Dialog(group="Geometry"));
  parameter Types.Volume V_solid(min=0, max=0.1) = 0 "Volume in the sleeve that is no gas: a thick wall, a filler"
    annotation (Dialog(group="Gas"));
  replaceable model Gas = Laws.Gases.PolytropicMuscleGas constrainedby Interfaces.Gas "Law of the gas"
    annotation (choicesAllMatching=true);
  replaceable model Wall = Laws.Heat.FilmWall constrainedby Interfaces.Wall "Law of the wall"
    annotation (choicesAllMatching=true);
  replaceable model Surroundings = Laws.Heat.StillAir constrainedby Interfaces.Surroundings
    "What the wall gives its heat to"
    annotation (choicesAllMatching=true);
  replaceable model FrictionHeat = Laws.Heat.LostFrictionHeat constrainedby Interfaces.FrictionHeat "Heat of friction"
    annotation (choicesAllMatching=true);
  replaceable model Braid = Laws.Forces.CylindricalBraid constrainedby Interfaces.Braid "Law of the sleeve"
    annotation (choicesAllMatching=true);
  outer Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-90,70},{-70,90}})));
protected
  final parameter Real crossings = 2*turns*(fibres/2)^2 - fibres/2 "Number of crossings (q), DP (47)";
  final parameter Types.Area A_fibre = w*(fibres*sqrt(L0^2 + (turns*Constants.pi*D0)^2) - z*crossings/2)
    "Area of contact between fibres and bladder, DP (48)";
public
  Braid braid(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Sleeve"
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  Gas gas(V=braid.V - V_solid, n=n_g, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p,
    T_reference=ambient.T, h_film=h_film, dynamics=ambient.dynamics) "Gas in the bladder"
    annotation (Placement(transformation(extent={{-60,30},{-40,50}})));
  Wall wall(A=max(0, Constants.pi*braid.D*braid.L - A_fibre), h_film=gas.h_wall, k=k_wall, t=t_wall) "Bladder as a wall"
    annotation (Placement(transformation(extent={{-70,-50},{-50,-30}})));
  Surroundings surroundings "What the wall gives its heat to"
    annotation (Placement(transformation(extent={{-35,-50},{-15,-30}})));
  Laws.Frictions.FibreFriction fibreFriction(L0=L0, D0=D0, turns=turns, t_wall=t_wall, A_ff=crossings*w*z, mu_d=mu_d,
    K_f=K_f)
    "Friction of fibre on fibre"
    annotation (Placement(transformation(extent={{20,-10},{40,10}})));
  Laws.Frictions.BladderFriction bladderFriction(L0=L0, D0=D0, turns=turns, t_wall=t_wall, A_fb=A_fibre, mu_fb=mu_fb)
    "Friction between fibres and bladder"
    annotation (Placement(transformation(extent={{50,-10},{70,10}})));
  FrictionHeat frictionHeat(P_fibre=fibreFriction.f*fibreFriction.v, P_bladder=bladderFriction.f*bladderFriction.v)
    "Heat of friction"
    annotation (Placement(transformation(extent={{-70,-85},{-50,-65}})));
equation
  connect(port, gas.port)
    annotation (Line(points={{-100,0}, {-65,0}, {-65,40}, {-60,40}}, color={0,90,160}));
  connect(port, braid.port)
    annotation (Line(points={{-100,0}, {-10,0}}, color={0,90,160}));
  connect(port, fibreFriction.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {15,15}, {15,0}, {20,0}}, color={0,90,160}));
  connect(port, bladderFriction.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {45,15}, {45,0}, {50,0}}, color={0,90,160}));
  connect(gas.heatPort, wall.heatPort)
    annotation (Line(points={{-50,30}, {-50,-25}, {-75,-25}, {-75,-40}, {-70,-40}}, color={190,30,0}));
  connect(gas.heatPort, frictionHeat.heatPort)
    annotation (Line(points={{-50,30}, {-50,-25}, {-75,-25}, {-75,-75}, {-70,-75}}, color={190,30,0}));
  connect(wall.outside, surroundings.heatPort)
    annotation (Line(points={{-50,-40}, {-35,-40}}, color={190,30,0}));
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
<p>Motion <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17), pressure and temperature DP
(59)-(60), heat DP (44)-(49), friction DP (68)-(71), geometry as in
<a href=\"modelica://PneumaticMuscle.Interfaces.Braid\">Interfaces.Braid</a>. The area that exchanges heat is what the
fibres leave free, A_q = max(0, pi D L - w (b N - z q/2)), q = 2 n (N/2)^2 - N/2; w and z are not tabulated, the fibre
thickness is taken for both. DP enclose gas in all of the volume, V_solid = 0.</p>
</html>"));
end Muscle;

within PneumaticMuscle.Muscles.Components;
model Muscle "McKibben muscle of Doumit and Pardoel; default parameters: latex bladder, DP Table 1"
  extends FibreSleeve;
  parameter Real n_g(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  parameter Types.ThermalConductivity k_wall(min=0.01, max=10) = 0.14 "Thermal conductivity of the bladder"
    annotation (Dialog(group="Heat"));
  parameter Types.CoefficientOfHeatTransfer h_film(min=0.1, max=1000) = 20
    "Film coefficient on both sides of the bladder"
    annotation (Dialog(group="Heat"));
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
  outer Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-90,70},{-70,90}})));
  Gas gas(V=braid.V - V_solid, n=n_g, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p,
    T_reference=ambient.T, h_film=h_film, dynamics=ambient.dynamics) "Gas in the bladder"
    annotation (Placement(transformation(extent={{-60,30},{-40,50}})));
  Wall wall(A=A_q, h_film=gas.h_wall, k=k_wall, t=t_wall) "Bladder as a wall"
    annotation (Placement(transformation(extent={{-70,-50},{-50,-30}})));
  Surroundings surroundings "What the wall gives its heat to"
    annotation (Placement(transformation(extent={{-35,-50},{-15,-30}})));
  FrictionHeat frictionHeat(P_fibre=fibreFriction.f*fibreFriction.v, P_bladder=bladderFriction.f*bladderFriction.v)
    "Heat of friction"
    annotation (Placement(transformation(extent={{-70,-85},{-50,-65}})));
equation
  connect(port, gas.port)
    annotation (Line(points={{-100,0}, {-65,0}, {-65,40}, {-60,40}}, color={0,90,160}));
  connect(gas.heatPort, wall.heatPort)
    annotation (Line(points={{-50,30}, {-50,-25}, {-75,-25}, {-75,-40}, {-70,-40}}, color={190,30,0}));
  connect(gas.heatPort, frictionHeat.heatPort)
    annotation (Line(points={{-50,30}, {-50,-25}, {-75,-25}, {-75,-75}, {-70,-75}}, color={190,30,0}));
  connect(wall.outside, surroundings.heatPort)
    annotation (Line(points={{-50,-40}, {-35,-40}}, color={190,30,0}));
  annotation (Documentation(info="<html>
<p>Motion <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17), pressure and temperature DP
(59)-(60), heat DP (44)-(49), friction DP (68)-(71), geometry as in
<a href=\"modelica://PneumaticMuscle.Interfaces.Braid\">Interfaces.Braid</a>; sleeve, friction and the area that
exchanges heat are those of <a href=\"modelica://PneumaticMuscle.Muscles.Components.FibreSleeve\">FibreSleeve</a>. DP
enclose gas in all of the volume, V_solid = 0.</p>
</html>"));
end Muscle;

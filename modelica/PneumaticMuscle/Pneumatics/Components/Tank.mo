within PneumaticMuscle.Pneumatics.Components;
model Tank "A rigid vessel"
  extends Interfaces.VesselTerminals;
  extends Icons.Vessel;
  parameter Types.Volume V(min=1e-6, max=10) = 2.1e-3 "Volume" annotation (Dialog(group="Geometry"));
  parameter Real n(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  parameter Types.GaugePressure p_start(min=-1.01e5, max=1e8) = 0 "Gauge pressure at the start"
    annotation (Dialog(group="Start"));
  parameter Types.Temperature T_start(min=200, max=500) = 293.15 "Temperature at the start"
    annotation (Dialog(group="Start"));
  parameter Boolean startIsReference = false
    "true: the polytropic law starts from p_start and T_start; false: from the ambient, DP (60)"
    annotation (Dialog(group="Start"));
  replaceable model Gas = Laws.Gases.PolytropicVesselGas constrainedby Interfaces.Gas "Law of the gas"
    annotation (choicesAllMatching=true);
  replaceable model Wall = Laws.Heat.MetalWall constrainedby Interfaces.Wall "Law of the wall"
    annotation (choicesAllMatching=true);
  replaceable model Surroundings = Laws.Heat.StillAir constrainedby Interfaces.Surroundings
    "What the wall gives its heat to"
    annotation (choicesAllMatching=true);
  outer Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{50,50},{90,90}})));
  final parameter Types.Area A = 2.5*Constants.pi*(2*V/Constants.pi)^(2/3)
    "Inner surface of a cylinder twice as long as wide";
  Gas gas(V=V, n=n, p_start=ambient.p + p_start, T_start=T_start,
    p_reference=if startIsReference then ambient.p + p_start else ambient.p,
    T_reference=if startIsReference then T_start else ambient.T, h_film=0, dynamics=ambient.dynamics)
      "Gas in the vessel"
    annotation (Placement(transformation(extent={{-50,0},{-10,40}})));
  Wall wall(A=A, h_film=gas.h_wall, k=50, t=0.01) "Wall of the vessel"
    annotation (Placement(transformation(extent={{0,-70},{40,-30}})));
  Surroundings surroundings "What the wall gives its heat to"
    annotation (Placement(transformation(extent={{55,-70},{95,-30}})));
equation
  connect(port, gas.port)
    annotation (Line(points={{-100,0}, {-55,0}, {-55,20}, {-50,20}}, color={0,90,160}));
  connect(gas.heatPort, wall.heatPort)
    annotation (Line(points={{-30,0}, {-30,-50}, {0,-50}}, color={190,30,0}));
  connect(wall.outside, surroundings.heatPort)
    annotation (Line(points={{40,-50}, {55,-50}}, color={190,30,0}));
  annotation (Documentation(info="<html>
<p>p_dot = n R T/V (m_in - m_out), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (63)-(66), in
<a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicVesselGas\">Laws.Gases.PolytropicVesselGas</a>, which takes no
heat from the wall: its polytropic exponent stands for the heat. Where a law of the gas asks for a wall, it is steel of
10 mm around a cylinder twice as long as wide, of which DP say nothing: A = 5/2 pi (2 V/pi)^(2/3), k = 50 W/(m.K).</p>
</html>"));
end Tank;

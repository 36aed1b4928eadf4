within PneumaticMuscle.CoSimulation;
model ValveAndGas "Valves and the gas behind them; the volume comes from outside"
  extends Icons.Bench;
  input Types.Current u_in(start=0.35) "Current of the inlet valve";
  input Types.Current u_out(start=0) "Current of the exhaust valve";
  input Types.GaugePressure p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply";
  input Types.Volume V(start=7.5e-5, min=1e-7) "Volume of the gas";
  input Types.VolumeFlowRate V_flow(start=0) "Rate of the volume";
  input Types.Area A(start=1.7e-3) "Area of the wall that exchanges heat";
  output Types.GaugePressure p "Gauge pressure of the gas";
  output Types.Temperature T "Temperature of the gas";
  parameter Real n_g(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  parameter Types.Length t_wall(min=1e-5, max=0.02) = 0.254e-3 "Thickness of the bladder"
    annotation (Dialog(group="Heat"));
  parameter Types.ThermalConductivity k_wall(min=0.01, max=10) = 0.14 "Thermal conductivity of the bladder"
    annotation (Dialog(group="Heat"));
  parameter Types.CoefficientOfHeatTransfer h_film(min=0.1, max=1000) = 20
    "Film coefficient on both sides of the bladder"
    annotation (Dialog(group="Heat"));
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-90,65},{-60,95}})));
  Pneumatics.Components.Supply supply(p_gauge=p_supply) "Air supply"
    annotation (Placement(transformation(extent={{-90,25},{-60,55}})));
  Pneumatics.Components.Atmosphere atmosphere "Outlet"
    annotation (Placement(transformation(extent={{-90,-55},{-60,-25}})));
  Pneumatics.Components.ValvePair valve(u_in=u_in, u_out=u_out) "Inlet and exhaust valve"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  RatedGas gas(V=V, V_flow=V_flow, n=n_g, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p,
    T_reference=ambient.T, h_film=h_film, dynamics=ambient.dynamics) "Gas in the bladder"
    annotation (Placement(transformation(extent={{10,-20},{50,20}})));
  Laws.Heat.FilmWall wall(A=A, h_film=gas.h_wall, k=k_wall, t=t_wall) "Bladder as a wall"
    annotation (Placement(transformation(extent={{25,-75},{55,-45}})));
  Laws.Heat.StillAir surroundings "What the wall gives its heat to"
    annotation (Placement(transformation(extent={{65,-75},{95,-45}})));
equation
  connect(supply.port, valve.supply)
    annotation (Line(points={{-60,40}, {-55,40}, {-55,12}, {-50,12}}, color={0,90,160}));
  connect(valve.exhaust, atmosphere.port)
    annotation (Line(points={{-50,-12}, {-55,-12}, {-55,-40}, {-60,-40}}, color={0,90,160}));
  connect(valve.port, gas.port)
    annotation (Line(points={{-10,0}, {10,0}}, color={0,90,160}));
  connect(gas.heatPort, wall.heatPort)
    annotation (Line(points={{30,-20}, {30,-40}, {20,-40}, {20,-60}, {25,-60}}, color={190,30,0}));
  connect(wall.outside, surroundings.heatPort)
    annotation (Line(points={{55,-60}, {65,-60}}, color={190,30,0}));
  p = gas.p - ambient.p;
  T = gas.T;
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8),
    __PamCosim(terminals="gas: p, V, V_flow, A"), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (59)-(60), (62), (44). Of the outputs none
depends at once on an input: pressure is a state, and temperature follows from it. Alone, with the volume held, it fills
a vessel of the volume of a muscle at rest.</p>
</html>"));
end ValveAndGas;

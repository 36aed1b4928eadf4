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
  parameter Types.Length t_wall(min=1e-5, max=0.02) = 0.254e-3 "Thickness of the bladder" annotation (Dialog(group="Heat"));
  parameter Types.ThermalConductivity k_wall(min=0.01, max=10) = 0.14 "Thermal conductivity of the bladder"
    annotation (Dialog(group="Heat"));
  parameter Types.CoefficientOfHeatTransfer h_film(min=0.1, max=1000) = 20 "Film coefficient on both sides of the bladder"
    annotation (Dialog(group="Heat"));
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p_supply) "Air supply";
  Components.Atmosphere atmosphere "Outlet";
  Components.ValvePair valve(u_in=u_in, u_out=u_out) "Inlet and exhaust valve";
  RatedGas gas(V=V, V_flow=V_flow, n=n_g, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p,
    T_reference=ambient.T, h_film=h_film) "Gas in the bladder";
  Laws.Heat.FilmWall wall(A=A, h_film=gas.h_wall, k=k_wall, t=t_wall) "Bladder as a wall";
  Laws.Heat.StillAir surroundings "What the wall gives its heat to";
equation
  connect(supply.port, valve.supply);
  connect(valve.exhaust, atmosphere.port);
  connect(valve.port, gas.port);
  connect(gas.heatPort, wall.heatPort);
  connect(wall.outside, surroundings.heatPort);
  p = gas.p - ambient.p;
  T = gas.T;
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8), Documentation(info="<html>
<p>DP (59)-(60), (62), (44). Of the outputs none depends at once on an input: pressure is a state, and temperature follows
from it. Alone, with the volume held, it fills a vessel of the volume of a muscle at rest.</p>
</html>"));
end ValveAndGas;

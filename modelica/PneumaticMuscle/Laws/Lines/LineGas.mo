within PneumaticMuscle.Laws.Lines;
model LineGas "The gas in a line: a rigid volume, by default without heat exchange"
  extends Icons.Vessel;
  Interfaces.GasPort port "Gas port"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Volume V "Volume" annotation (Dialog(group="Geometry"));
  parameter Types.ThermalConductance UA = 0 "Conductance to the surroundings" annotation (Dialog(group="Heat"));
  Types.AbsolutePressure p "Absolute pressure";
  Types.Temperature T "Temperature";
  Types.Mass m(nominal=1e-6) "Mass of the gas";
protected
  outer Ambient ambient "Surroundings";
equation
  port.p = p;
  port.T = T;
  p*V = m*Constants.R*T;
  der(m) = port.m_flow;
  V*der(p) = (Constants.gamma - 1)*(port.H_flow - UA*(T - ambient.T));
  annotation (Documentation(info="<html>
<p>Mass and energy balance of an ideal gas, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43) and
(59) at constant volume, with heat UA (T - T_atm) lost to the surroundings. The start is left to the line.</p>
</html>"));
end LineGas;

within PneumaticMuscle.Laws.Lines;
model LineGas "The gas in a line: a volume, by default rigid and without heat exchange"
  extends Icons.Vessel;
  Interfaces.GasPort port "Gas port"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Volume V "Volume at ambient pressure" annotation (Dialog(group="Geometry"));
  parameter Real expansion(unit="1/Pa") = 0 "Relative growth of the volume by the gauge pressure"
    annotation (Dialog(group="Geometry"));
  parameter Types.ThermalConductance UA = 0 "Conductance to the surroundings" annotation (Dialog(group="Heat"));
  Types.AbsolutePressure p "Absolute pressure";
  Types.Temperature T "Temperature";
  Types.Mass m(nominal=1e-6) "Mass of the gas";
protected
  outer Ambient ambient "Surroundings";
  Real w(unit="1") = 1 + expansion*(p - ambient.p) "Volume by that at ambient pressure";
equation
  port.p = p;
  port.T = T;
  p*V*w = m*Constants.R*T;
  der(m) = port.m_flow;
  V*(w + Constants.gamma*p*expansion)*der(p) = (Constants.gamma - 1)*(port.H_flow - UA*(T - ambient.T));
  annotation (Documentation(info="<html>
<p>Mass and energy balance of an ideal gas, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43),
(53) and (59) in a volume V (1 + expansion p_gauge), with heat UA (T - T_atm) lost to the surroundings; the hose
takes the work p dV and gives it back. Hoses are sold with their expansion per pressure (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6801</a>). The start is left to the line.</p>
</html>"));
end LineGas;

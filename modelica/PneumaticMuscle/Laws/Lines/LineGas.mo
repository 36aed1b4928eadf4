within PneumaticMuscle.Laws.Lines;
model LineGas "The gas in a line: a rigid volume without heat exchange"
  extends Icons.Vessel;
  Interfaces.GasPort port "Gas port"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Volume V "Volume" annotation (Dialog(group="Geometry"));
  Types.AbsolutePressure p "Absolute pressure";
  Types.Temperature T "Temperature";
  Types.Mass m(nominal=1e-6) "Mass of the gas";
equation
  port.p = p;
  port.T = T;
  p*V = m*Constants.R*T;
  der(m) = port.m_flow;
  V*der(p) = (Constants.gamma - 1)*port.H_flow;
  annotation (Documentation(info="<html>
<p>Mass and energy balance of an ideal gas, DP (43) and (59) at constant volume. The start is left to the line.</p>
</html>"));
end LineGas;

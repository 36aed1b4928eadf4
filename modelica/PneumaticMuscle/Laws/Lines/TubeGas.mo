within PneumaticMuscle.Laws.Lines;
model TubeGas "The gas in a thin tube: a rigid volume at the temperature of its surroundings"
  extends Icons.Vessel;
  Interfaces.GasPort port "Gas port"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Volume V "Volume" annotation (Dialog(group="Geometry"));
  Types.AbsolutePressure p "Absolute pressure";
  outer Ambient ambient "Surroundings";
equation
  port.p = p;
  port.T = ambient.T;
  V*der(p) = Constants.R*ambient.T*port.m_flow;
  annotation (Documentation(info="<html>
<p>V p_dot = R T_atm m_flow: the wall of a thin tube is large compared with the gas in it and exchanges all heat
with it. The start is left to the line.</p>
</html>"));
end TubeGas;

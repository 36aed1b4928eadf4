within PneumaticMuscle.Pneumatics.Components;
model Atmosphere "The air outside, at ambient temperature"
  extends Icons.Surroundings;
  Interfaces.GasPort port "Gas port"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Types.GaugePressure p_gauge = 0 "Gauge pressure outside" annotation (Dialog(group="Surroundings"));
  outer Ambient ambient "Surroundings";
equation
  port.p = ambient.p + p_gauge;
  port.T = ambient.T;
  annotation (Documentation(info="<html>
<p>port.p = p_atm + p_gauge, port.T = T_atm, whatever flows: an infinite volume.</p>
</html>"));
end Atmosphere;

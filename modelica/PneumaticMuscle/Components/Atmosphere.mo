within PneumaticMuscle.Components;
model Atmosphere "The air outside, at ambient temperature"
  Interfaces.GasPort port "Gas port";
  parameter Types.GaugePressure p_gauge = 0 "Gauge pressure outside" annotation (Dialog(group="Surroundings"));
  outer Ambient ambient "Surroundings";
equation
  port.p = ambient.p + p_gauge;
  port.T = ambient.T;
  annotation (Documentation(info="<html>
<p>port.p = p_atm + p_gauge, port.T = T_atm, whatever flows: an infinite volume.</p>
</html>"));
end Atmosphere;

within PneumaticMuscle.Pneumatics.Components;
model Atmosphere "The air outside, at ambient temperature"
  extends Interfaces.PressureSource;
  extends Icons.Surroundings;
  parameter Types.GaugePressure p_gauge = 0 "Gauge pressure outside" annotation (Dialog(group="Surroundings"));
equation
  port.p = ambient.p + p_gauge;
  annotation (Documentation(info="<html>
<p>port.p = p_atm + p_gauge, port.T = T_atm, whatever flows: an infinite volume.</p>
</html>"));
end Atmosphere;

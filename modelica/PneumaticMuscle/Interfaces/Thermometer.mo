within PneumaticMuscle.Interfaces;
partial model Thermometer "What the instrument makes of the gas temperature"
  GasPort port "Where it sits";
  parameter Types.Temperature T_start "Reading at the start";
  Types.Temperature T "Reading";
equation
  port.m_flow = 0;
  port.H_flow = 0;
  annotation (Documentation(info="<html>
<p>Takes no gas. Left to the extending class: the equation of T.</p>
</html>"));
end Thermometer;

within PneumaticMuscle.Interfaces;
partial model Thermometer "What the instrument makes of the gas temperature"
  extends Icons.Thermometer;
  GasPort port "Where it sits"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  input Types.MassFlowRate m_flow = 0 "Gas that flows past it";
  parameter Types.Temperature T_start "Reading at the start" annotation (Dialog(group="Start"));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  Interfaces.Signals.TemperatureOutput T "Reading"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  port.m_flow = 0;
  port.H_flow = 0;
  annotation (Documentation(info="<html>
<p>Takes no gas. Left to the extending class: the equation of T. A bench that does not say what flows past the
instrument means still gas.</p>
</html>"));
end Thermometer;

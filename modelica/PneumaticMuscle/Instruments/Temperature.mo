within PneumaticMuscle.Instruments;
model Temperature "A thermometer in the gas of the muscle, at its port"
  extends Interfaces.Instrument;
  Interfaces.GasPort port_a "Side of the muscle"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Interfaces.GasPort port_b "Side of what feeds it"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.TemperatureOutput T "Temperature reading in the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  replaceable model Thermometer = Sensors.IdealThermometer constrainedby Interfaces.Thermometer "Thermometer"
    annotation (choicesAllMatching=true);
  replaceable model TemperatureChannel = Sensors.DirectTemperature constrainedby Interfaces.TemperatureChannel
    "Measuring channel of the temperature"
    annotation (choicesAllMatching=true);
  outer Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-90,50},{-50,90}})));
  Thermometer thermometer(T_start=ambient.T, m_flow=port_b.m_flow) "Thermometer"
    annotation (Placement(transformation(extent={{-20,30},{20,70}})));
  TemperatureChannel channel(dynamics=dynamics) "Measuring channel of the temperature"
    annotation (Placement(transformation(extent={{50,30},{90,70}})));
equation
  connect(port_b, port_a)
    annotation (Line(points={{-100,0}, {100,0}}, color={0,90,160}));
  connect(port_a, thermometer.port)
    annotation (Line(points={{100,0}, {0,0}, {0,30}}, color={0,90,160}));
  connect(thermometer.T, channel.u)
    annotation (Line(points={{20,50}, {50,50}}, color={0,0,127}));
  connect(channel.y, T)
    annotation (Line(points={{90,50}, {95,50}, {95,95}, {0,95}, {0,100}}, color={0,0,127}));
  annotation (Documentation(info="<html>
<p>T = port_a.T, as the channel passes it on. What flows into the muscle flows past it.</p>
</html>"));
end Temperature;

within PneumaticMuscle.Instruments;
model Pressure "A pressure transducer at the muscle"
  extends Interfaces.Instrument;
  Interfaces.GasPort port "Pressure tap"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model PressureChannel = Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  Manometer manometer "Pressure transducer"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  PressureChannel channel(dynamics=dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(port, manometer.port)
    annotation (Line(points={{0,100}, {0,-25}, {-30,-25}, {-30,-20}}, color={0,90,160}));
  connect(manometer.p, channel.u)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,0,127}));
  connect(channel.y, p)
    annotation (Line(points={{70,0}, {100,0}}, color={0,0,127}));
  annotation (Documentation(info="<html>
<p>p = port.p - p_atm, as the channel passes it on.</p>
</html>"));
end Pressure;

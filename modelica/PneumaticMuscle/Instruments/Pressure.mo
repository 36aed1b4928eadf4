within PneumaticMuscle.Instruments;
model Pressure "A pressure transducer at the muscle"
  extends Interfaces.Instrument;
  Interfaces.GasPort port "Pressure tap"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  output Types.GaugePressure p "Gauge pressure in the muscle";
  replaceable model Manometer = Sensors.GaugePressure constrainedby Interfaces.Manometer "Pressure transducer"
    annotation (choicesAllMatching=true);
  replaceable model PressureChannel = Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  Manometer manometer "Pressure transducer";
  PressureChannel channel(u=manometer.p, dynamics=dynamics) "Measuring channel of the pressure";
equation
  connect(port, manometer.port);
  p = channel.y;
  annotation (Documentation(info="<html>
<p>p = port.p - p_atm, as the channel passes it on.</p>
</html>"));
end Pressure;

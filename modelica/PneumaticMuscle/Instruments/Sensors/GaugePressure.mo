within PneumaticMuscle.Instruments.Sensors;
model GaugePressure "A gauge pressure transducer"
  extends Interfaces.Manometer;
equation
  p = port.p - ambient.p;
  annotation (Documentation(info="<html>
<p>p = port.p - p_atm.</p>
</html>"));
end GaugePressure;

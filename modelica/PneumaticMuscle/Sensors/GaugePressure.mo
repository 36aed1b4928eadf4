within PneumaticMuscle.Sensors;
model GaugePressure "A gauge pressure transducer"
  extends Interfaces.Manometer;
equation
  p = port.p - ambient.p;
end GaugePressure;

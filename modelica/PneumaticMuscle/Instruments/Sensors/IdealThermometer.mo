within PneumaticMuscle.Instruments.Sensors;
model IdealThermometer "Reads the temperature of the gas at once"
  extends Interfaces.Thermometer;
equation
  T = port.T;
  annotation (Documentation(info="<html>
<p>T = port.T.</p>
</html>"));
end IdealThermometer;

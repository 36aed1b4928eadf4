within PneumaticMuscle.Sensors;
model IdealThermometer "Reads the temperature of the gas at once"
  extends Interfaces.Thermometer;
equation
  T = port.T;
end IdealThermometer;

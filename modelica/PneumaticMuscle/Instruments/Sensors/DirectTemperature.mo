within PneumaticMuscle.Instruments.Sensors;
model DirectTemperature "Records the temperature as the transducer gives it"
  extends Interfaces.TemperatureChannel;
equation
  y = u;
  annotation (Documentation(info="<html>
<p>y = u.</p>
</html>"));
end DirectTemperature;

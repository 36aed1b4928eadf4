within PneumaticMuscle.Instruments.Sensors;
model DirectPressure "Records the pressure as the transducer gives it"
  extends Interfaces.PressureChannel;
equation
  y = u;
  annotation (Documentation(info="<html>
<p>y = u.</p>
</html>"));
end DirectPressure;

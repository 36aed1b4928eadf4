within PneumaticMuscle.Instruments.Sensors;
model DirectPosition "Records the position as the transducer gives it"
  extends Interfaces.PositionChannel;
equation
  y = u;
  annotation (Documentation(info="<html>
<p>y = u.</p>
</html>"));
end DirectPosition;

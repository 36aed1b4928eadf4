within PneumaticMuscle.Instruments.Sensors;
model DirectForce "Records the force as the transducer gives it"
  extends Interfaces.ForceChannel;
equation
  y = u;
  annotation (Documentation(info="<html>
<p>y = u.</p>
</html>"));
end DirectForce;

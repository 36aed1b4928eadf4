within PneumaticMuscle.Laws.Frictions;
model NoFriction "No force at all"
  extends Interfaces.ForceElement;
equation
  f = 0;
  annotation (Documentation(info="<html>
<p>f = 0: the default where a friction or a bladder may be left out.</p>
</html>"));
end NoFriction;

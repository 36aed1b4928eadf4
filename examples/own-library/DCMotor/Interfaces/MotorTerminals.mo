within DCMotor.Interfaces;
partial model MotorTerminals "The terminals of a motor: an effect that has them too is connected in parallel"
  Mesh mesh "Circuit of the armature";
  Flange shaft "Shaft";
end MotorTerminals;

within DCMotor.Interfaces;
partial model MotorTerminals "The terminals of a motor: an effect that has them too lies beside the motor"
  Mesh mesh "Circuit of the armature";
  Flange shaft "Shaft";
end MotorTerminals;

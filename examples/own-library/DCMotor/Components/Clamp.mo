within DCMotor.Components;
model Clamp "Holds a shaft"
  Interfaces.Flange shaft "Shaft";
equation
  shaft.phi = 0;
end Clamp;

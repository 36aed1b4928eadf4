within PneumaticMuscle.Components;
model Ambient "The surroundings of a bench"
  parameter Types.AbsolutePressure p(min=5e4, max=1.2e5) = 101325 "Ambient pressure";
  parameter Types.Temperature T(min=250, max=330) = 293.15 "Ambient temperature";
end Ambient;

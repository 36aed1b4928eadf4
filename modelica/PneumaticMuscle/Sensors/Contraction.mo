within PneumaticMuscle.Sensors;
model Contraction "A displacement transducer at the load end"
  Interfaces.Flange flange "Load end";
  Types.Length x "Reading";
equation
  x = flange.s;
  flange.f = 0;
end Contraction;

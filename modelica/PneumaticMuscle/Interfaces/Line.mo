within PneumaticMuscle.Interfaces;
partial model Line "What lies between the valves and the muscle or vessel"
  GasPort port_a "Valve end";
  GasPort port_b "Muscle or vessel end";
end Line;

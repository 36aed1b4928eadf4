within PneumaticMuscle.Interfaces;
partial model Line "What lies between the valves and the muscle or vessel"
  GasPort port_a "Valve end";
  GasPort port_b "Muscle or vessel end";
  annotation (Documentation(info="<html>
<p>Left to the extending class: four equations between the two ends, for pressure, temperature, mass and enthalpy
flow.</p>
</html>"));
end Line;

within PneumaticMuscle.Interfaces;
partial model VesselTerminals "The one terminal of a store of gas"
  GasPort port "Gas port";
end VesselTerminals;

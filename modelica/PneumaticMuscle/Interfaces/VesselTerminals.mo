within PneumaticMuscle.Interfaces;
partial model VesselTerminals "The one terminal of a store of gas"
  GasPort port "Gas port";
  annotation (Documentation(info="<html>
<p>One gas port: a tank, a muscle, and whatever is connected beside one.</p>
</html>"));
end VesselTerminals;

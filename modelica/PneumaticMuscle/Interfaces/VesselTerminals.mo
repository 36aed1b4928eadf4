within PneumaticMuscle.Interfaces;
partial model VesselTerminals "The one terminal of a store of gas"
  extends Icons.Named;
  GasPort port "Gas port"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  annotation (Documentation(info="<html>
<p>One gas port: a tank, a muscle, and whatever is connected beside one.</p>
</html>"));
end VesselTerminals;

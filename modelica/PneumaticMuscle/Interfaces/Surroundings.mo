within PneumaticMuscle.Interfaces;
partial model Surroundings "What a wall gives its heat to"
  extends Icons.Surroundings;
  HeatPort heatPort "Outer side of the wall"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings of the bench";
  annotation (Documentation(info="<html>
<p>Left to the extending class: one equation between heatPort.T and heatPort.Q_flow.</p>
</html>"));
end Surroundings;

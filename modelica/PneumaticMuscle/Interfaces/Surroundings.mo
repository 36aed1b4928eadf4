within PneumaticMuscle.Interfaces;
partial model Surroundings "What a wall gives its heat to"
  HeatPort heatPort "Outer side of the wall";
  outer Components.Ambient ambient "Surroundings of the bench";
  annotation (Documentation(info="<html>
<p>Left to the extending class: one equation between heatPort.T and heatPort.Q_flow.</p>
</html>"));
end Surroundings;

within PneumaticMuscle.Instruments;
model Force "A load cell between the muscle and what it pulls"
  extends Interfaces.Instrument;
  Interfaces.Flange flange_a "Side of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Flange flange_b "Side of what it pulls"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  Interfaces.Signals.ForceOutput F "Pull of the muscle"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  replaceable model ForceChannel = Sensors.DirectForce constrainedby Interfaces.ForceChannel
    "Measuring channel of the force"
    annotation (choicesAllMatching=true);
  Sensors.Pull loadCell "Load cell"
    annotation (Placement(transformation(extent={{-20,-20},{20,20}})));
  ForceChannel channel(dynamics=dynamics) "Measuring channel of the force"
    annotation (Placement(transformation(extent={{40,-20},{80,20}})));
equation
  connect(flange_a, loadCell.flange_a)
    annotation (Line(points={{0,100}, {0,20}}, color={0,110,60}));
  connect(loadCell.flange_b, flange_b)
    annotation (Line(points={{0,-20}, {0,-100}}, color={0,110,60}));
  connect(loadCell.F, channel.u)
    annotation (Line(points={{20,0}, {40,0}}, color={0,0,127}));
  connect(channel.y, F)
    annotation (Line(points={{80,0}, {100,0}}, color={0,0,127}));
  annotation (Documentation(info="<html>
<p>The force between the two flanges, positive in pull, as the channel passes it on.</p>
</html>"));
end Force;

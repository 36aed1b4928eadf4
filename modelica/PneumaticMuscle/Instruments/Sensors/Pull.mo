within PneumaticMuscle.Instruments.Sensors;
model Pull "A load cell between two flanges"
  extends Icons.Sensor;
  Interfaces.Flange flange_a "Side of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Flange flange_b "Side of what it pulls on"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  Interfaces.Signals.ForceOutput F "Reading, positive in pull"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  flange_a.s = flange_b.s;
  flange_a.f + flange_b.f = 0;
  F = -flange_b.f;
  annotation (Documentation(info="<html>
<p>Reads the force with which the muscle pulls, without travel of its own.</p>
</html>"));
end Pull;

within PneumaticMuscle.Sensors;
model Pull "A load cell between two flanges"
  Interfaces.Flange flange_a "Side of the muscle";
  Interfaces.Flange flange_b "Side of what it pulls on";
  Types.Force F "Reading, positive in pull";
equation
  flange_a.s = flange_b.s;
  flange_a.f + flange_b.f = 0;
  F = -flange_b.f;
  annotation (Documentation(info="<html>
<p>Reads the force with which the muscle pulls, without travel of its own.</p>
</html>"));
end Pull;

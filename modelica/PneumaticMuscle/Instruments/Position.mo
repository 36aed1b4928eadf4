within PneumaticMuscle.Instruments;
model Position "A displacement transducer at the load end"
  extends Interfaces.Instrument;
  Interfaces.Flange flange "Load end"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  output Types.Length x "Contraction";
  replaceable model PositionChannel = Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
    annotation (choicesAllMatching=true);
  Sensors.Contraction ruler "Displacement transducer";
  PositionChannel channel(u=ruler.x, dynamics=dynamics) "Measuring channel of the position";
equation
  connect(flange, ruler.flange);
  x = channel.y;
  annotation (Documentation(info="<html>
<p>x = flange.s, as the channel passes it on: zero at the length at rest.</p>
</html>"));
end Position;

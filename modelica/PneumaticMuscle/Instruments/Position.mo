within PneumaticMuscle.Instruments;
model Position "A displacement transducer at the load end"
  extends Interfaces.Instrument;
  Interfaces.Flange flange "Load end"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.LengthOutput x "Contraction"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  replaceable model PositionChannel = Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
    annotation (choicesAllMatching=true);
  Sensors.Contraction ruler "Displacement transducer"
    annotation (Placement(transformation(extent={{-50,-20},{-10,20}})));
  PositionChannel channel(dynamics=dynamics) "Measuring channel of the position"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(flange, ruler.flange)
    annotation (Line(points={{-100,0}, {-50,0}}, color={0,110,60}));
  connect(ruler.x, channel.u)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,0,127}));
  connect(channel.y, x)
    annotation (Line(points={{70,0}, {100,0}}, color={0,0,127}));
  annotation (Documentation(info="<html>
<p>x = flange.s, as the channel passes it on: zero at the length at rest.</p>
</html>"));
end Position;

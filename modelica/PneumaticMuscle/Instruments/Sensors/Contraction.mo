within PneumaticMuscle.Instruments.Sensors;
model Contraction "A displacement transducer at the load end"
  extends Icons.Ruler;
  Interfaces.Flange flange "Load end"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.LengthOutput x "Reading"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  x = flange.s;
  flange.f = 0;
  annotation (Documentation(info="<html>
<p>x = flange.s: the load end is at zero when the muscle is at its length at rest.</p>
</html>"));
end Contraction;

within PneumaticMuscle.Interfaces;
partial model ForceElement "A force between the ends of a muscle that opposes its contraction"
  extends MuscleTerminals;
  extends Icons.ForceLaw;
  Types.Length x "Contraction";
  Types.Velocity v "Speed of contraction";
  Types.GaugePressure p_gauge "Gauge pressure";
  Types.Force f "Force that opposes contraction";
  outer Components.Ambient ambient "Surroundings";
equation
  x = L0 - (flange_b.s - flange_a.s);
  v = der(x);
  p_gauge = port.p - ambient.p;
  flange_a.f = f;
  flange_b.f = -f;
  port.m_flow = 0;
  port.H_flow = 0;
  annotation (Documentation(info="<html>
<p>The equation that defines f is the only one left to the extending class. The gas port is a pressure tap.</p>
</html>"));
end ForceElement;

within PneumaticMuscle.Interfaces;
partial model Manometer "What the instrument makes of the gas pressure"
  extends Icons.Manometer;
  GasPort port "Pressure tap"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  Interfaces.Signals.GaugePressureOutput p "Reading"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  outer Ambient ambient "Surroundings";
equation
  port.m_flow = 0;
  port.H_flow = 0;
  annotation (Documentation(info="<html>
<p>A pressure tap, which takes no gas. Left to the extending class: the equation of p.</p>
</html>"));
end Manometer;

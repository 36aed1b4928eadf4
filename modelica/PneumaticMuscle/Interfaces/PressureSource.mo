within PneumaticMuscle.Interfaces;
partial model PressureSource "Gas of ambient temperature at a pressure that no flow changes"
  extends Icons.Named;
  GasPort port "Gas port"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  outer Ambient ambient "Surroundings";
equation
  port.T = ambient.T;
  annotation (Documentation(info="<html>
<p>An infinite volume. Left to the extending class: the pressure, ambient.p and a gauge pressure.</p>
</html>"));
end PressureSource;

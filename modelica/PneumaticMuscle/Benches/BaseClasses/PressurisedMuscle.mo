within PneumaticMuscle.Benches.BaseClasses;
partial model PressurisedMuscle "A muscle at rest under the pressure that was measured in it"
  extends Icons.Named;
  Interfaces.Signals.GaugePressureInput p(start=200e3, min=-101e3) "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{-200,20},{-180,40}}),
      iconTransformation(extent={{-110,30},{-90,50}})));
  Pneumatics.ImposedPressure source(resistance(R(min=1) = 1)) "The measured pressure"
    annotation (Placement(transformation(extent={{-110,-20},{-70,20}})));
  Muscles.Physical muscle "Muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(muscle.port, source.port)
    annotation (Line(points={{30,0}, {-70,0}}, color={0,90,160}));
  connect(p, source.p)
    annotation (Line(points={{-190,30}, {-115,30}, {-115,0}, {-110,0}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{160,120}})),
    Documentation(info="<html>
<p>At rest nothing flows: the resistance of
<a href=\"modelica://PneumaticMuscle.Pneumatics.ImposedPressure\">Pneumatics.ImposedPressure</a> is without effect and
may be small. Left to the extending class: what holds the load end, and its force at the start,
<code>muscle.F_start</code>.</p>
</html>"));
end PressurisedMuscle;

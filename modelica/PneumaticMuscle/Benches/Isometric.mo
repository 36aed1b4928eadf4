within PneumaticMuscle.Benches;
model Isometric "A muscle whose contraction is imposed, driven by current-driven valves; its pull is measured"
  extends Interfaces.Rig;
  extends BaseClasses.CurrentSupply;
  extends BaseClasses.HungMuscle;
  extends BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends BaseClasses.ForceReading(channel_F(dynamics=ambient.dynamics));
  extends BaseClasses.TemperatureReading(thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow),
    channel_T(dynamics=ambient.dynamics));
  Interfaces.Signals.LengthInput s(start=0.02) "Imposed contraction"
    annotation (Placement(transformation(extent={{-200,-140},{-180,-120}}),
      iconTransformation(extent={{-110,-100},{-90,-80}})));
  Mechanics.Components.ImposedPosition drive "What moves the load end"
    annotation (Placement(transformation(extent={{30,-150},{70,-110}})));
equation
  connect(line.port_b, muscle.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(muscle.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(muscle.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,50}, {-30,50}, {-30,170}}, color={0,90,160}));
  connect(muscle.flange_a, loadCell.flange_a)
    annotation (Line(points={{50,-20}, {50,-45}}, color={0,110,60}));
  connect(loadCell.flange_b, drive.flange)
    annotation (Line(points={{50,-85}, {50,-110}}, color={0,110,60}));
  connect(s, drive.s_wanted)
    annotation (Line(points={{-190,-130}, {30,-130}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>The muscle of <a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Isotonic</a> between a ceiling and a drive. The
imposed contraction reaches the muscle through a critically damped filter of 5 ms,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.ImposedPosition\">Components.ImposedPosition</a>, because the
speed of the end enters the pressure, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (59). It
starts from zero contraction whatever the input says. The braid carries no push: a negative pull does not occur in a
sleeve, but the base model allows it beyond full contraction, 3 L^2 &lt; b^2.</p>
</html>"));
end Isometric;

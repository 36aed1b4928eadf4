within PneumaticMuscle.Benches;
model TankFilling "A tank that is filled and emptied through current-driven valves, DP section 4.4"
  extends Interfaces.Rig;
  extends BaseClasses.CurrentSupply;
  extends BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends BaseClasses.TemperatureReading(T(displayUnit="degC"),
    thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow), channel_T(dynamics=ambient.dynamics));
  Pneumatics.Components.Tank tank "Tank"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(line.port_b, tank.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(tank.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(tank.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,50}, {-30,50}, {-30,170}}, color={0,90,160}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    experiment(StopTime=60, Interval=0.06, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (60), (62)-(66), Figs. 4 and 5: eight volumes,
two supplies, 0.35 A. The library's tests hold the times against quadrature.</p>
</html>"));
end TankFilling;

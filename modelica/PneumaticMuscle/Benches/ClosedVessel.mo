within PneumaticMuscle.Benches;
model ClosedVessel "A vessel under pressure with everything shut"
  extends Interfaces.Rig;
  extends BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends BaseClasses.TemperatureReading(thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow),
    channel_T(dynamics=ambient.dynamics));
  Pneumatics.Components.Tank tank(V=1e-4, p_start=7e5, startIsReference=true) "Vessel"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(tank.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(tank.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,50}, {-30,50}, {-30,170}}, color={0,90,160}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    experiment(StopTime=150, Interval=0.15, Tolerance=1e-6), Documentation(info="<html>
<p>The test of tightness: fill, shut, and watch the pressure. As it stands nothing changes; what does is an effect. A
leak is found in proportion to the volume: without <code>tank.V</code> only the ratio is known.</p>
</html>"));
end ClosedVessel;

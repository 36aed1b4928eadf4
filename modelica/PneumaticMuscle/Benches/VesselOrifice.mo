within PneumaticMuscle.Benches;
model VesselOrifice "A vessel that empties or fills through a plain orifice"
  extends Interfaces.Rig;
  extends BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends BaseClasses.TemperatureReading(thermometer(T_start=tank.T_start, m_flow=tank.port.m_flow),
    channel_T(dynamics=ambient.dynamics));
  parameter Types.GaugePressure p_outside(min=-1.01e5, max=1e8) = 0 "Gauge pressure outside"
    annotation (Dialog(group="Surroundings"));
  Pneumatics.Components.Tank tank(V=16.2e-3, p_start=6.9e5, startIsReference=true) "Vessel"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  Pneumatics.Components.PlainOrifice orifice "Hole"
    annotation (Placement(transformation(extent={{-50,-20},{-90,20}})));
  Pneumatics.Components.Atmosphere atmosphere(p_gauge=p_outside) "Outside"
    annotation (Placement(transformation(extent={{-170,-20},{-130,20}})));
equation
  connect(tank.port, orifice.port_a)
    annotation (Line(points={{30,0}, {-50,0}}, color={0,90,160}));
  connect(orifice.port_b, atmosphere.port)
    annotation (Line(points={{-90,0}, {-130,0}}, color={0,90,160}));
  connect(tank.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(tank.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,50}, {-30,50}, {-30,170}}, color={0,90,160}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    experiment(StopTime=60, Interval=0.06, Tolerance=1e-6), Documentation(info="<html>
<p>The polytropic law starts from the state of the vessel: T = T_start (p/p_start)^((n - 1)/n), absolute
pressures.</p>
</html>"));
end VesselOrifice;

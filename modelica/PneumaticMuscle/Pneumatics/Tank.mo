within PneumaticMuscle.Pneumatics;
model Tank "Valves driven by currents, from a tank that droops and is refilled through a throttle"
  extends Components.PneumaticsWithPair(pair(C_A=C_A));
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of what refills the tank"
    annotation (Placement(transformation(extent={{-110,-70},{-90,-50}})));
  parameter Real C_A(unit="1", min=0.1, max=3) = 0.699 "Calibration of the effective area, both valves"
    annotation (Dialog(group="Flow"));
  parameter Types.Volume V(min=1e-5, max=10) = 0.5e-3 "Volume of the tank" annotation (Dialog(group="Geometry"));
  parameter Types.GaugePressure p_start(min=-1.01e5, max=1e8) = 207e3 "Gauge pressure in the tank at the start"
    annotation (Dialog(group="Start"));
  parameter Types.Length d(min=1e-6, max=0.1) = 0.3e-3 "Diameter of the throttle before the tank"
    annotation (Dialog(group="Geometry"));
  Components.Supply supply "What refills the tank"
    annotation (Placement(transformation(extent={{-90,45},{-60,75}})));
  Components.PlainOrifice throttle(d=d) "Throttle before the tank"
    annotation (Placement(transformation(extent={{-45,45},{-15,75}})));
  Components.Tank tank(V=V, p_start=p_start, startIsReference=true) "Tank"
    annotation (Placement(transformation(extent={{10,45},{40,75}})));
equation
  connect(supply.port, throttle.port_a)
    annotation (Line(points={{-60,60}, {-45,60}}, color={0,90,160}));
  connect(throttle.port_b, tank.port)
    annotation (Line(points={{-15,60}, {10,60}}, color={0,90,160}));
  connect(tank.port, pair.supply)
    annotation (Line(points={{10,60}, {-10,60}, {-10,25}, {-45,25}, {-45,12}, {-40,12}}, color={0,90,160}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-100,-60}, {-95,-60}, {-95,29}, {-91,29}, {-91,60}, {-90,60}}, color={0,0,127}));
  connect(u_in, pair.u_in)
    annotation (Line(points={{-100,60}, {-95,60}, {-95,33}, {-28,33}, {-28,20}}, color={0,0,127}));
  connect(u_out, pair.u_out)
    annotation (Line(points={{-100,0}, {-49,0}, {-49,29}, {-12,29}, {-12,20}}, color={0,0,127}));
  annotation (defaultComponentName="valve", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42), (62) and, for the tank, (63)-(66): its
pressure falls with what the muscle takes, V p_dot = n R T (m_in - m_out). A throttle of the least diameter is a tank
that nothing refills. Where the pressure before the valves was recorded,
<a href=\"modelica://PneumaticMuscle.Pneumatics.Valves\">Valves</a> needs no model of the tank. Size and throttle are
for illustration.</p>
</html>"));
end Tank;

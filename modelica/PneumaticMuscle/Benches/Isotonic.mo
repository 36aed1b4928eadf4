within PneumaticMuscle.Benches;
model Isotonic "A muscle that lifts a hanging mass, driven by current-driven valves, DP Fig. 2"
  extends Interfaces.Rig;
  extends BaseClasses.CurrentSupply;
  extends BaseClasses.LiftedMass;
  extends BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends BaseClasses.PositionReading(channel_x(dynamics=ambient.dynamics));
  extends BaseClasses.TemperatureReading(thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow),
    channel_T(dynamics=ambient.dynamics));
equation
  connect(line.port_b, muscle.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(muscle.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(muscle.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,50}, {-30,50}, {-30,170}}, color={0,90,160}));
  connect(muscle.flange_a, ruler.flange)
    annotation (Line(points={{50,-20}, {50,-40}, {80,-40}, {80,-85}, {95,-85}}, color={0,110,60}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> section 3 and Fig. 2, equations DP (17)-(18),
(40)-(42), (44)-(49), (59)-(60), (62), (68)-(71): the base model. The mass rests on the stop of the full length at the
start. By default it is filled from 207 kPa at 0.35 A.</p>
</html>"));
end Isotonic;

within PneumaticMuscle.Benches;
model SwitchedMuscle "A muscle of imposed contraction that on-off valves fill from a source whose pressure is measured"
  extends Interfaces.Rig;
  extends BaseClasses.ValveSupply(p_supply(start=500e3),
    valve(u_in=u_open*u_in, u_out=u_open*u_out, C_A=0.2));
  extends BaseClasses.HungMuscle;
  extends BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends BaseClasses.TemperatureReading(thermometer(T_start=ambient.T, m_flow=muscle.port.m_flow),
    channel_T(dynamics=ambient.dynamics));
  Interfaces.Signals.RealInput u_in(start=1, unit="1") "Command of the inlet valve: 0 shut, 1 open"
    annotation (Placement(transformation(extent={{-200,50},{-180,70}}),
      iconTransformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.RealInput u_out(start=0, unit="1") "Command of the exhaust valve: 0 shut, 1 open"
    annotation (Placement(transformation(extent={{-200,-40},{-180,-20}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.LengthInput s(start=0.02) "Imposed contraction"
    annotation (Placement(transformation(extent={{-200,-85},{-180,-65}}),
      iconTransformation(extent={{-110,-100},{-90,-80}})));
  Mechanics.Components.ImposedPosition drive(tau=1e-3) "What moves the load end"
    annotation (Placement(transformation(extent={{30,-95},{70,-55}})));
protected
  constant Types.Current u_open = Functions.openingCurrent(1e-5) "Current at which DP (62) opens 10 mm2";
equation
  connect(line.port_b, muscle.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(muscle.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(muscle.port, thermometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,50}, {-30,50}, {-30,170}}, color={0,90,160}));
  connect(muscle.flange_a, drive.flange)
    annotation (Line(points={{50,-20}, {50,-55}}, color={0,110,60}));
  connect(s, drive.s_wanted)
    annotation (Line(points={{-190,-75}, {30,-75}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    experiment(StopTime=0.5, Interval=0.001, Tolerance=1e-6), Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Benches.Isometric\">Isometric</a> with valves that are open or shut: a
command of 1 opens 10 <code>valve.C_A</code> mm2, so that <code>valve.C_A</code> is the effective area of the open
valve. A finite tank needs no model of its own where the pressure before the valve is measured: it is the input
<code>p_supply</code>, with its droop. The contraction passes a critically damped filter of 1 ms,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.ImposedPosition\">Components.ImposedPosition</a>.</p>
</html>"));
end SwitchedMuscle;

within PneumaticMuscle.Pneumatics;
model SwitchedValves "An inlet and an exhaust valve that are open or shut, from a supply whose pressure is known"
  extends Components.PneumaticsWithPair(pair(u_in=u_open*u_in, u_out=u_open*u_out, C_A=C_A));
  Interfaces.Signals.RealInput u_in(unit="1", start=1) "Command of the inlet valve, 0 shut, 1 open"
    annotation (Placement(transformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.RealInput u_out(unit="1", start=0) "Command of the exhaust valve, 0 shut, 1 open"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=500e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-110,-70},{-90,-50}})));
  parameter Real C_A(unit="1", min=0.01, max=3) = 0.2 "Effective area of an open valve by 10 mm2, both valves"
    annotation (Dialog(group="Flow"));
  Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-90,35},{-60,65}})));
protected
  constant Types.Current u_open = Functions.openingCurrent(1e-5) "Current at which DP (62) opens 10 mm2";
equation
  connect(supply.port, pair.supply)
    annotation (Line(points={{-60,50}, {-45,50}, {-45,12}, {-40,12}}, color={0,90,160}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-100,-60}, {-95,-60}, {-95,50}, {-90,50}}, color={0,0,127}));
  annotation (defaultComponentName="valve", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42): a command of 1 opens 10 C_A mm2, as in
<a href=\"modelica://PneumaticMuscle.Benches.SwitchedMuscle\">Benches.SwitchedMuscle</a>. Pulse width modulation is the
command itself where it was recorded, 0 and 1; a duty cycle in its place is the mean area but for the threshold of DP
(62), 2.5 % of the command.</p>
</html>"));
end SwitchedValves;

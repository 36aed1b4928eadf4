within PneumaticMuscle.Pneumatics;
model Valves "An inlet and an exhaust valve driven by currents, from a supply whose pressure is known"
  extends Components.PneumaticsWithPair(pair(C_A=C_A));
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=207e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-110,-70},{-90,-50}})));
  parameter Real C_A(unit="1", min=0.1, max=3) = 0.699 "Calibration of the effective area, both valves"
    annotation (Dialog(group="Flow"));
  Components.Supply supply "Air supply"
    annotation (Placement(transformation(extent={{-90,35},{-60,65}})));
equation
  connect(supply.port, pair.supply)
    annotation (Line(points={{-60,50}, {-45,50}, {-45,12}, {-40,12}}, color={0,90,160}));
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-100,-60}, {-95,-60}, {-95,25}, {-91,25}, {-91,50}, {-90,50}}, color={0,0,127}));
  connect(u_in, pair.u_in)
    annotation (Line(points={{-100,60}, {-95,60}, {-95,29}, {-28,29}, {-28,20}}, color={0,0,127}));
  connect(u_out, pair.u_out)
    annotation (Line(points={{-100,0}, {-49,0}, {-49,25}, {-12,25}, {-12,20}}, color={0,0,127}));
  annotation (defaultComponentName="valve", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42) and (62),
<a href=\"modelica://PneumaticMuscle.Pneumatics.Components.ValvePair\">Components.ValvePair</a>. The supply is as
measured before the valves.</p>
</html>"));
end Valves;

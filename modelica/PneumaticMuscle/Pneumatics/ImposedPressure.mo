within PneumaticMuscle.Pneumatics;
model ImposedPressure "The pressure in the muscle as it was measured"
  extends Interfaces.Pneumatics;
  extends Icons.GasSource;
  Interfaces.Signals.GaugePressureInput p(start=200e3, min=-101e3) "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Components.Supply supply "The measured pressure"
    annotation (Placement(transformation(extent={{-80,-20},{-40,20}})));
  Components.Droop resistance(R=1e4) "So little that the rate of the pressure is not needed"
    annotation (Placement(transformation(extent={{0,-20},{40,20}})));
equation
  connect(supply.port, resistance.port_a)
    annotation (Line(points={{-40,0}, {0,0}}, color={0,90,160}));
  connect(resistance.port_b, port)
    annotation (Line(points={{40,0}, {100,0}}, color={0,90,160}));
  connect(p, supply.p_gauge)
    annotation (Line(points={{-100,0}, {-80,0}}, color={0,0,127}));
  annotation (defaultComponentName="source", Documentation(info="<html>
<p>The muscle takes whatever gas its pressure needs. A pressure that is imposed outright would have to be
differentiated for that; it is imposed through a resistance of 10 Pa per gram a second, which a muscle of 0.1 litre
follows within 10 microseconds, V R/(n R_gas T). Nothing is said of what is before the muscle: neither valves nor line,
leak nor gas can be told from such a recording.</p>
</html>"));
end ImposedPressure;

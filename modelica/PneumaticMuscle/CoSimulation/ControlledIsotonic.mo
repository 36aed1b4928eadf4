within PneumaticMuscle.CoSimulation;
model ControlledIsotonic "The isotonic bench with the controller, in one piece"
  extends Icons.Bench;
  Interfaces.Signals.LengthInput x_wanted(start=0.02) "Contraction wanted"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureOutput p = bench.p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{90,70},{110,90}})));
  Interfaces.Signals.LengthOutput x = bench.x "Contraction"
    annotation (Placement(transformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.TemperatureOutput T = bench.T "Temperature in the muscle"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Interfaces.Signals.CurrentOutput u_in = controller.u_in "Current of the inlet valve"
    annotation (Placement(transformation(extent={{90,-50},{110,-30}})));
  Interfaces.Signals.CurrentOutput u_out = controller.u_out "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{90,-90},{110,-70}})));
  ContractionController controller "Controller"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.Isotonic bench(p_supply=207e3) "Muscle that lifts a mass"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(bench.x, controller.x)
    annotation (Line(points={{70,0}, {75,0}, {75,25}, {-75,25}, {-75,8}, {-70,8}}, color={0,0,127}));
  connect(x_wanted, controller.x_wanted)
    annotation (Line(points={{-100,0}, {-75,0}, {-75,-8}, {-70,-8}}, color={0,0,127}));
  connect(controller.u_in, bench.u_in)
    annotation (Line(points={{-30,8}, {25,8}, {25,12}, {30,12}}, color={0,0,127}));
  connect(controller.u_out, bench.u_out)
    annotation (Line(points={{-30,-8}, {25,-8}, {25,0}, {30,0}}, color={0,0,127}));
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8), Documentation(info="<html>
<p>What a coupling of <a href=\"modelica://PneumaticMuscle.CoSimulation.ValveAndGas\">ValveAndGas</a>,
<a href=\"modelica://PneumaticMuscle.CoSimulation.MuscleAndLoad\">MuscleAndLoad</a> and
<a href=\"modelica://PneumaticMuscle.CoSimulation.ContractionController\">ContractionController</a> comes to as its
steps become small.</p>
</html>"));
end ControlledIsotonic;

within PneumaticMuscle.CoSimulation;
model ControlledIsotonic "The isotonic bench with the controller, in one piece"
  extends Icons.Bench;
  input Types.Length x_wanted(start=0.02) "Contraction wanted";
  output Types.GaugePressure p = bench.p "Gauge pressure in the muscle";
  output Types.Length x = bench.x "Contraction";
  output Types.Temperature T = bench.T "Temperature in the muscle";
  output Types.Current u_in = controller.u_in "Current of the inlet valve";
  output Types.Current u_out = controller.u_out "Current of the exhaust valve";
  ContractionController controller(x=bench.x, x_wanted=x_wanted) "Controller"
    annotation (Placement(transformation(extent={{-70,-20},{-30,20}})));
  Benches.Isotonic bench(u_in=controller.u_in, u_out=controller.u_out, p_supply=207e3) "Muscle that lifts a mass"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8), Documentation(info="<html>
<p>What a coupling of <a href=\"modelica://PneumaticMuscle.CoSimulation.ValveAndGas\">ValveAndGas</a>,
<a href=\"modelica://PneumaticMuscle.CoSimulation.MuscleAndLoad\">MuscleAndLoad</a> and
<a href=\"modelica://PneumaticMuscle.CoSimulation.ContractionController\">ContractionController</a> comes to as its
steps become small.</p>
</html>"));
end ControlledIsotonic;

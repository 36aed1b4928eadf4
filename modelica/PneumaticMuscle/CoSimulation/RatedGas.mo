within PneumaticMuscle.CoSimulation;
model RatedGas "The gas of a muscle whose volume and its rate come from outside, DP (59)-(60)"
  extends Interfaces.Gas;
  input Types.VolumeFlowRate V_flow "Rate of the volume";
equation
  V*der(p) = -Constants.gamma*p*V_flow + (Constants.gamma - 1)*(heatPort.Q_flow + port.H_flow);
  T = T_reference*(p/p_reference)^((n - 1)/n);
  h_wall = h_film;
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicMuscleGas\">Laws.Gases.PolytropicMuscleGas</a> with V_flow
in place of der(V): an input is known only while a step is made, so a tool cannot differentiate it.</p>
</html>"));
end RatedGas;

within PneumaticMuscle.CoSimulation;
model RatedGas "The gas of a muscle whose volume and its rate come from outside, DP (59)-(60)"
  extends Interfaces.Gas(V(start=7.5e-5), n=1.2, p_start=101325, T_start=293.15, p_reference=101325,
    T_reference=293.15, h_film=20);
  input Types.VolumeFlowRate V_flow "Rate of the volume";
equation
  V*der(p) = -Constants.gamma*p*V_flow + (Constants.gamma - 1)*(heatPort.Q_flow + port.H_flow);
  T = T_reference*(p/p_reference)^((n - 1)/n);
  h_wall = h_film;
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicMuscleGas\">Laws.Gases.PolytropicMuscleGas</a> with V_flow
in place of der(V): an input is known only while a step is made, so a tool cannot differentiate it. The values by
default are n_g, h_film and the volume at rest of
<a href=\"modelica://PneumaticMuscle.Muscles.Components.Muscle\">Components.Muscle</a> and the air of
<a href=\"modelica://PneumaticMuscle.Ambient\">Ambient</a>, so that a tool can translate it alone;
<a href=\"modelica://PneumaticMuscle.CoSimulation.ValveAndGas\">ValveAndGas</a> states its own.</p>
</html>"));
end RatedGas;

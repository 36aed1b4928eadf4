within PneumaticMuscle.Laws.Heat;
model PrintedWall "A bladder without films of air, DP (45) as printed"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow = k/t*A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
  annotation (Documentation(info="<html>
<p>Q_flow = k/t A (T - T_outside), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (44)-(45) as
printed. With the balances of mass and energy
(<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a>) a muscle on 207 kPa
fills and its gas warms by 4.5 K, of the size that DP's model has in Fig. 12. With the temperature by the power law,
<a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicMuscleGas\">PolytropicMuscleGas</a>, it stalls at 50 kPa: that
law holds the gas hot for as long as it is under pressure, and heat leaks out for ever. The defect is the pair. See
<a href=\"modelica://PneumaticMuscle.Examples.Validation.GasTemperature\">Validation.GasTemperature</a>.</p>
</html>"));
end PrintedWall;

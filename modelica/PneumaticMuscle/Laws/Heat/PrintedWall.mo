within PneumaticMuscle.Laws.Heat;
model PrintedWall "A bladder without films of air, DP (45) as printed"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow = k/t*A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
  annotation (Documentation(info="<html>
<p>Q_flow = k/t A (T - T_outside), DP (44)-(45) as printed. With the balances of mass and energy
(<code>Effects.GasEnergy.EnergyGas</code>) a muscle on 207 kPa fills and its gas warms by 4.5 K, of the size that DP's model has in
Fig. 12. With the temperature by the power law, <code>PolytropicMuscleGas</code>, it stalls at 50 kPa: that law holds the gas
hot for as long as it is under pressure, and heat leaks out for ever. The defect is the pair. See
<code>Validation.GasTemperature</code>.</p>
</html>"));
end PrintedWall;

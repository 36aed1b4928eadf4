within PneumaticMuscle.Examples;
model PrintedWallIsotonic "The isotonic bench with the heat transfer coefficient as printed, DP (45)"
  extends Benches.Isotonic(muscle(redeclare model Wall = Laws.Heat.PrintedWall));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>h_c = k/t_b, DP (45), without films of air. The pressure stalls far below the supply's: DP (60), read as a power
law, holds the gas hot for as long as it is under pressure, so heat leaks out for ever. With
<code>Effects.GasEnergy.EnergyGas</code> it does not, see <code>PrintedWallEnergyGas</code>.</p>
</html>"));
end PrintedWallIsotonic;

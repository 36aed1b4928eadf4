within PneumaticMuscle.Examples;
model PrintedWallIsotonic "The isotonic bench with the heat transfer coefficient as printed, DP (45)"
  extends Benches.Isotonic(muscle(redeclare model Wall = Laws.Heat.PrintedWall));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>h_c = k/t_b, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (45), without films of air. The
pressure stalls far below the supply's: DP (60), read as a power law, holds the gas hot for as long as it is under
pressure, so heat leaks out for ever. With
<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a> it does not, see
<a href=\"modelica://PneumaticMuscle.Examples.PrintedWallEnergyGas\">PrintedWallEnergyGas</a>.</p>
</html>"));
end PrintedWallIsotonic;

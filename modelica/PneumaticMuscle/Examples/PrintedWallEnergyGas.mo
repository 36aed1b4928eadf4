within PneumaticMuscle.Examples;
model PrintedWallEnergyGas "The isotonic bench with DP (45) as printed and the balances of mass and energy"
  extends PrintedWallIsotonic(muscle(redeclare model Gas = Effects.GasEnergy.EnergyGas));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>What <code>PrintedWallIsotonic</code> becomes when the temperature follows from DP (43), (53) and (54) instead of DP (60).
It fills to the supply's pressure. The film coefficient of <code>Effects.GasEnergy.EnergyGas</code> has no place in
<code>Laws.Heat.PrintedWall</code> and changes nothing here.</p>
</html>"));
end PrintedWallEnergyGas;

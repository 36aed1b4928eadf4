within PneumaticMuscle.Examples;
model PrintedWallEnergyGas "The isotonic bench with DP (45) as printed and the balances of mass and energy"
  extends PrintedWallIsotonic(muscle(redeclare model Gas = Effects.GasEnergy.EnergyGas));
  extends Icons.Example;
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>What <a href=\"modelica://PneumaticMuscle.Examples.PrintedWallIsotonic\">PrintedWallIsotonic</a> becomes when the
temperature follows from <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53) and (54) instead
of DP (60). It fills to the supply's pressure. The film coefficient of
<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a> has no place in
<a href=\"modelica://PneumaticMuscle.Laws.Heat.PrintedWall\">Laws.Heat.PrintedWall</a> and changes nothing here.</p>
</html>"));
end PrintedWallEnergyGas;

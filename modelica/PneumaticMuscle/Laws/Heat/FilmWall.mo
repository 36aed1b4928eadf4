within PneumaticMuscle.Laws.Heat;
model FilmWall "A bladder with a film of air on both sides"
  extends Interfaces.Wall;
equation
  heatPort.Q_flow*(2/h_film + t/k) = A*(heatPort.T - outside.T);
  outside.Q_flow = -heatPort.Q_flow;
  annotation (Documentation(info="<html>
<p>Q_dot = h_c A (T_atm - T), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (44), with 1/h_c =
1/h_film + t/k + 1/h_film. The printed h_c = k/t_b, DP (45), leaves out the films;
<a href=\"modelica://PneumaticMuscle.Laws.Heat.PrintedWall\">PrintedWall</a> is that form. It goes with the balances of
mass and energy (<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a>),
but not with <a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicMuscleGas\">PolytropicMuscleGas</a>: a muscle on
a 207 kPa supply would stall at 50 kPa, because the power law never lets the temperature return to ambient. Since that
law is the default of the muscle, this wall is too.</p>
<p>Open: a film of its own outside. 1/h_c = 2/h_film + t/k also where h_film depends on the jet or the pressure inside,
of which the air outside knows nothing: with the laws of the gas ConvectiveGas, FlexibleGas, RealGas, FreeConvectionGas
and GeneralGas of <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy\">Effects.GasEnergy</a>.</p>
</html>"));
end FilmWall;

within PneumaticMuscle.Examples;
model PrintedWallIsotonic "The isotonic bench with the heat transfer coefficient as printed, DP (45)"
  extends Benches.Isotonic(muscle(redeclare model Wall = Components.PrintedWall));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>h_c = k/t_b, DP (45), without films of air. The pressure stalls far below the supply's: the polytropic law
(60) holds the gas hot for as long as it is under pressure, so heat leaks out for ever.</p>
</html>"));
end PrintedWallIsotonic;

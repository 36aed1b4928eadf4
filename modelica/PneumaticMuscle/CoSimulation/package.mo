within PneumaticMuscle;
package CoSimulation "A bench in pieces, each an FMU of its own, for coupling"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.CoSimulation.ValveAndGas\">ValveAndGas</a> and
<a href=\"modelica://PneumaticMuscle.CoSimulation.MuscleAndLoad\">MuscleAndLoad</a> are
<a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Benches.Isotonic</a> cut where the gas meets the sleeve: the gas
has the pressure, the muscle gives back its volume, the rate of it and the area of its wall. None of these follows at
once from what comes back, so there is no algebraic loop between them.
<a href=\"modelica://PneumaticMuscle.CoSimulation.ContractionController\">ContractionController</a> and
<a href=\"modelica://PneumaticMuscle.CoSimulation.ServoController\">ServoController</a> close the loop from the
contraction to the currents of the valves;
<a href=\"modelica://PneumaticMuscle.CoSimulation.ControlledIsotonic\">ControlledIsotonic</a> is all of it in one piece,
what a coupling of the three is compared with.</p>
</html>"));
end CoSimulation;

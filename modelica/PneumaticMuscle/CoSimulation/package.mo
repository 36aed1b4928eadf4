within PneumaticMuscle;
package CoSimulation "A bench in pieces, each an FMU of its own, for coupling"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p><code>ValveAndGas</code> and <code>MuscleAndLoad</code> are <code>Benches.Isotonic</code> cut where the gas meets the
sleeve: the gas has the pressure, the muscle gives back its volume, the rate of it and the area of its wall. None of these
follows at once from what comes back, so there is no algebraic loop between them. <code>ContractionController</code> and <code>ServoController</code> close the
loop from the contraction to the currents of the valves; <code>ControlledIsotonic</code> is all of it in one piece, what a
coupling of the three is compared with.</p>
</html>"));
end CoSimulation;

within PneumaticMuscle.Effects;
package ValveDynamics "Valves that follow their currents late"
  extends Icons.ValveDynamics;
  annotation (Documentation(info="<html>
<p>The family <code>valve_dynamics</code>: a delay or a lag between the command of a valve and its opening: of the
command, of the current in the coil, of the plunger or spool, of the opening; at a limited rate or not, of either
valve.</p>
<p>Fingerprint: pressure and contraction are late at every switching of a valve; the holds are right. Members differ in
how the flow begins.</p>
</html>"));
end ValveDynamics;

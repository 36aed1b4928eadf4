within PneumaticMuscle.Effects;
package ValveDynamics "Valves that follow their currents late"
  extends Icons.ValveDynamics;
  annotation (Documentation(info="<html>
<p>The family <code>valve_dynamics</code>: a delay or a lag between the current of a valve and its opening.</p>
<p>Fingerprint: pressure and contraction are late at every switching of a valve; the holds are right. Members differ in how the flow begins.</p>
</html>"));
end ValveDynamics;
